#pragma once

#include <string>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"

#include "experiments/circle_patterns/run.h"

namespace cirque {

/// Refuses an unknown domain, and flags given on the command line that this domain does not read.
Status CheckDomainFlags(const std::string& domain);

/// What the job asks of a map of the surface. Vertices that the job names are those of a mesh file
/// with `num_file_vertices` vertices, from 1.
StatusOr<MapRequest> RequestOf(const CirclePatternsJob& job, Index num_file_vertices,
                               const Surface& surface);

}  // namespace cirque
