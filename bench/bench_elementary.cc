// Elementary functions of arrays beside the library's, one after another.
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include "cirque/core/types.h"
#include "cirque/math/circle_angle.h"
#include "cirque/math/elementary_arrays.h"
#include "cirque/math/half_angles.h"

#include "bench/random_numbers.h"

namespace cirque {
namespace {

constexpr int kNumbers = 4096;

template <class Function>
void TimeArrays(benchmark::State& state, const Function& function) {
  const std::vector<double> x = RandomNumbers(kNumbers, 1e-3, kPi - 1e-3);
  const std::vector<double> y = RandomNumbers(kNumbers, -3, 3);
  std::vector<double> result(kNumbers);
  for (auto _ : state) {
    function(x, y, &result);
    benchmark::DoNotOptimize(result.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kNumbers);
}

template <class Function>
auto OneByOne(const Function& function) {
  return [function](const auto& x, const auto& y, std::vector<double>* result) {
    for (int i = 0; i < kNumbers; ++i) (*result)[i] = function(x[i], y[i]);
  };
}

const auto kExp = OneByOne([](double, double y) { return std::exp(y); });
const auto kLog = OneByOne([](double x, double) { return std::log(x); });
const auto kSin = OneByOne([](double x, double) { return std::sin(x); });
const auto kAtan2 = OneByOne([](double x, double y) { return std::atan2(x, y); });
const auto kHalfAngle = OneByOne([](double x, double y) {
  return HalfAngle(y, CircleAngle{0, x, 1});
});
const auto kExponentials = [](const auto&, const auto& y, auto* result) {
  Exponentials(y, *result);
};
const auto kLogarithms = [](const auto& x, const auto&, auto* result) { Logarithms(x, *result); };
const auto kSines = [](const auto& x, const auto&, auto* result) { Sines(x, *result); };
const auto kArctangents = [](const auto& x, const auto& y, auto* result) {
  Arctangents(x, y, *result);
};
const auto kHalfAngles = [](const auto& x, const auto& y, auto* result) {
  static const std::vector<double> ones(kNumbers, 1.0);
  HalfAngles(y, x, ones, *result);
};

BENCHMARK_CAPTURE(TimeArrays, exp, kExp);
BENCHMARK_CAPTURE(TimeArrays, exponentials, kExponentials);
BENCHMARK_CAPTURE(TimeArrays, log, kLog);
BENCHMARK_CAPTURE(TimeArrays, logarithms, kLogarithms);
BENCHMARK_CAPTURE(TimeArrays, sin, kSin);
BENCHMARK_CAPTURE(TimeArrays, sines, kSines);
BENCHMARK_CAPTURE(TimeArrays, atan2, kAtan2);
BENCHMARK_CAPTURE(TimeArrays, arctangents, kArctangents);
BENCHMARK_CAPTURE(TimeArrays, half_angle, kHalfAngle);
BENCHMARK_CAPTURE(TimeArrays, half_angles, kHalfAngles);

}  // namespace
}  // namespace cirque
