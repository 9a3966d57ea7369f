#pragma once

#include <string>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"

#include "experiments/circle_patterns/run.h"

namespace cirque {

/// Refuses an unknown domain, and flags given on the command line that this domain does not read.
Status CheckDomainFlags(const std::string& domain);

/// Maps the surface to the domain asked for, a part of the plane. Vertices that the job names are
/// those of a mesh file with `num_file_vertices` vertices, from 1.
Status MapToDomain(const CirclePatternsJob& job, Index num_file_vertices, const Surface& surface,
                   const SolveControl& control, Parameterization* map);

}  // namespace cirque
