#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace cirque {

/// Minimises over single parameters, first come first served, until no entry of the gradient
/// exceeds `threshold`, or so many moves are made that it would be dear. `move(i, change)` moves parameter i and calls change(j, by) for every entry of the
/// gradient that changes. False, and nothing done, where so many entries stand out that the whole
/// energy is meant.
template <class Move>
bool RelaxParameters(double threshold, Eigen::Ref<Eigen::VectorXd> gradient, const Move& move) {
  constexpr int kMovesEach = 20;
  constexpr double kMostParameters = 0.02, kMostMoves = 0.1;  // as shares of all parameters
  const auto all = static_cast<double>(gradient.size());
  std::vector<int> queue;
  std::vector<bool> waits(gradient.size(), false);
  const auto push = [&](int i) {
    if (waits[i] || !(std::abs(gradient[i]) > threshold)) return;
    waits[i] = true;
    queue.push_back(i);
  };
  for (int i = 0; i < gradient.size(); ++i) push(i);
  if (static_cast<double>(queue.size()) > kMostParameters * all) return false;
  const std::size_t most =
      std::min(kMovesEach * queue.size(), static_cast<std::size_t>(kMostMoves * all) + 1);
  for (std::size_t k = 0; k < queue.size() && k < most; ++k) {
    const int i = queue[k];
    waits[i] = false;
    if (!(std::abs(gradient[i]) > threshold)) continue;
    move(i, [&](int j, double by) {
      gradient[j] += by;
      push(j);
    });
  }
  return true;
}

}  // namespace cirque
