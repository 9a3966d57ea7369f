#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/pipeline/domain.h"

#include "experiments/circle_patterns/run.h"

namespace cirque {

/// "plane, disk, ...".
std::vector<std::string> DomainNames();

/// Refuses an unknown domain, and flags that the domain asked for does not read.
Status CheckDomainFlags(const CirclePatternsJob& job);

/// Maps the surface to the domain asked for, anything but the plane. Vertices that the job names
/// are those of a mesh file with `num_file_vertices` vertices, from 0.
Status MapToDomain(const CirclePatternsJob& job, Index num_file_vertices, const Surface& surface,
                   const SolveControl& control, Parameterization* map);

}  // namespace cirque
