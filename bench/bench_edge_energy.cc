#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "cirque/core/types.h"
#include "cirque/math/circle_angle.h"

namespace cirque {
namespace {

constexpr int kEdges = 4096;

struct Sample {
  double d, alpha_i, alpha_j, theta;
};

/// Edges of random coherent triangles at d_e + offset, offset normal with the given deviation.
std::vector<Sample> RandomEdges(double deviation) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(0.1, 1.5);
  std::normal_distribution<double> offset(0.0, deviation);
  std::vector<Sample> edges(kEdges);
  for (Sample& e : edges) {
    e.alpha_i = angle(random);
    e.alpha_j = angle(random);
    e.theta = kPi - e.alpha_i - e.alpha_j;
    e.d = MinimalLogRatio(e.alpha_i, e.alpha_j) + offset(random);
  }
  return edges;
}

template <typename F>
void TimeEdges(benchmark::State& state, const F& function, double deviation) {
  const std::vector<Sample> edges = RandomEdges(deviation);
  for (auto _ : state) {
    for (const Sample& e : edges) benchmark::DoNotOptimize(function(e));
  }
  state.SetItemsProcessed(state.iterations() * kEdges);
}

const auto kHalfAngle = [](const Sample& e) { return HalfAngle(e.d, e.theta); };
const auto kPotential = [](const Sample& e) { return EdgePotential(e.d, e.theta); };
const auto kExcess = [](const Sample& e) { return EdgeExcess(e.d, e.alpha_i, e.alpha_j); };

BENCHMARK_CAPTURE(TimeEdges, half_angle, kHalfAngle, 1.0);
BENCHMARK_CAPTURE(TimeEdges, potential, kPotential, 1.0);
BENCHMARK_CAPTURE(TimeEdges, excess_near, kExcess, 1e-3);
BENCHMARK_CAPTURE(TimeEdges, excess_far, kExcess, 3.0);

}  // namespace
}  // namespace cirque
