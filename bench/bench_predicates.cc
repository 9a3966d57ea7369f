#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Eigen::Vector2d;

constexpr int kPoints = 4096;

/// Random points, where the filter decides, or points of a grid, most quadruples of which it
/// cannot.
std::vector<Vector2d> Points(bool grid) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Vector2d> points(kPoints);
  for (int i = 0; i < kPoints; ++i) {
    points[i] =
        grid ? 0.1 * Vector2d(i % 2, i / 2 % 2) : Vector2d(uniform(random), uniform(random));
  }
  return points;
}

void TimeOrientation(benchmark::State& state, bool grid) {
  const std::vector<Vector2d> p = Points(grid);
  for (auto _ : state) {
    for (int i = 0; i + 2 < kPoints; ++i) {
      benchmark::DoNotOptimize(OrientationSign(p[i], p[i + 1], p[i + 2]));
    }
  }
  state.SetItemsProcessed(state.iterations() * (kPoints - 2));
}

void TimeInCircle(benchmark::State& state, bool grid) {
  const std::vector<Vector2d> p = Points(grid);
  for (auto _ : state) {
    for (int i = 0; i + 3 < kPoints; ++i) {
      benchmark::DoNotOptimize(InCircleSign(p[i], p[i + 1], p[i + 2], p[i + 3]));
    }
  }
  state.SetItemsProcessed(state.iterations() * (kPoints - 3));
}

BENCHMARK_CAPTURE(TimeOrientation, filtered, false);
BENCHMARK_CAPTURE(TimeInCircle, filtered, false);
BENCHMARK_CAPTURE(TimeInCircle, exact_on_squares, true);

}  // namespace
}  // namespace cirque
