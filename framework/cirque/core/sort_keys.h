#pragma once

#include <utility>
#include <vector>

namespace cirque {

/// Sorts by value, then by index; no value may be NaN. In linear time where the values' logarithms are
/// spread, for they are dealt into as many buckets by their bits first; these are sorted on all cores.
void SortKeys(std::vector<std::pair<double, int>>* keys);

}  // namespace cirque
