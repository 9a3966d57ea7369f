#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cirque/mesh/preflight.h"

namespace cirque {

/// Everything in the report that forbids a parameterization, each with where it is and what to do;
/// empty when nothing does. `components` lists the polygons of each component; `one_sided_edge` is
/// where a surface that is not orientable shows it. Vertices and faces are counted from 1.
std::string DescribeProblems(const PreflightReport& report,
                             const std::vector<std::vector<Index>>& components,
                             std::pair<Index, Index> one_sided_edge);

}  // namespace cirque
