#include <vector>

#include <benchmark/benchmark.h>

#include "cirque/core/types.h"
#include "cirque/math/clausen.h"

#include "bench/random_numbers.h"

#ifdef CIRQUE_GSL
#include <gsl/gsl_sf_clausen.h>
#endif

namespace cirque {
namespace {

constexpr int kArguments = 4096;

void TimeFunction(benchmark::State& state, double (*function)(double), double lower, double upper) {
  const std::vector<double> arguments = RandomNumbers(kArguments, lower, upper);
  for (auto _ : state) {
    for (const double x : arguments) benchmark::DoNotOptimize(function(x));
  }
  state.SetItemsProcessed(state.iterations() * kArguments);
}

BENCHMARK_CAPTURE(TimeFunction, ours_0_2pi, Clausen, 0.0, 2 * kPi);
BENCHMARK_CAPTURE(TimeFunction, ours_0_pi, Clausen, 0.0, kPi);
BENCHMARK_CAPTURE(TimeFunction, ours_reduced, Clausen, -1e4, 1e4);
#ifdef CIRQUE_GSL
BENCHMARK_CAPTURE(TimeFunction, gsl_0_2pi, gsl_sf_clausen, 0.0, 2 * kPi);
BENCHMARK_CAPTURE(TimeFunction, gsl_0_pi, gsl_sf_clausen, 0.0, kPi);
BENCHMARK_CAPTURE(TimeFunction, gsl_reduced, gsl_sf_clausen, -1e4, 1e4);
#endif

}  // namespace
}  // namespace cirque
