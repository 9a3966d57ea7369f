#pragma once

#include <functional>
#include <string>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"

#include "experiments/circle_patterns/job.h"

namespace cirque {

/// Refuses an unknown domain, and flags that are given and that this domain does not read.
Status CheckDomainFlags(const std::string& domain,
                        const std::function<bool(const std::string& flag)>& is_given);

/// What the job asks of a map of the surface. Vertices that the job names are those of a mesh file
/// with `num_file_vertices` vertices, from 1.
StatusOr<MapRequest> RequestOf(const CirclePatternsJob& job, Index num_file_vertices,
                               const Surface& surface);

}  // namespace cirque
