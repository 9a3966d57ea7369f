#pragma once

#include <functional>

#include "cirque/linear/multigrid.h"

namespace cirque {

/// Runs body(ranks) on so many ranks that are threads of this process. Their systems are dense: the
/// first rank gathers the rows and factors them.
void RunOnThreadRanks(int num_ranks, const std::function<void(Ranks& ranks)>& body);

}  // namespace cirque
