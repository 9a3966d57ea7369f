#include "cirque/math/elementary_arrays.h"

#include <array>
#include <cmath>
#include <limits>

#include "cirque/core/types.h"
#include "cirque/math/arctangent.h"
#include "cirque/math/elementary.h"
#include "cirque/math/lane_map.h"

namespace cirque {
namespace {

using One = std::array<double, 1>;
using Two = std::array<double, 2>;

struct ExponentialMap {
  static constexpr std::size_t kInputs = 1;
  static bool IsOrdinary(const One& x) { return std::abs(x[0]) <= kLargestExponent; }
  template <class T>
  [[gnu::always_inline]] static T Of(const std::array<T, 1>& x) {
    return Exponential(x[0]);
  }
  static double OfOther(const One& x) { return std::exp(x[0]); }
};

struct LogarithmMap {
  static constexpr std::size_t kInputs = 1;
  static bool IsOrdinary(const One& x) {
    return x[0] >= std::numeric_limits<double>::min() && x[0] <= std::numeric_limits<double>::max();
  }
  template <class T>
  [[gnu::always_inline]] static T Of(const std::array<T, 1>& x) {
    return Logarithm(x[0]);
  }
  static double OfOther(const One& x) { return std::log(x[0]); }
};

struct SineMap {
  static constexpr std::size_t kInputs = 1;
  static bool IsOrdinary(const One& x) { return x[0] >= 0 && x[0] <= kPi; }
  template <class T>
  [[gnu::always_inline]] static T Of(const std::array<T, 1>& x) {
    return SineToPi(x[0]);
  }
  static double OfOther(const One& x) { return std::sin(x[0]); }
};

struct ArctangentMap {
  static constexpr std::size_t kInputs = 2;
  static bool IsOrdinary(const Two& yx) { return HasOrdinaryArctangent(yx[0], yx[1]); }
  template <class T>
  [[gnu::always_inline]] static T Of(const std::array<T, 2>& yx) {
    return OrdinaryArctangent(yx[0], yx[1]);
  }
  static double OfOther(const Two& yx) { return std::atan2(yx[0], yx[1]); }
};

}  // namespace

void Exponentials(std::span<const double> x, std::span<double> result) {
  MapLanes<ExponentialMap>({x.data()}, x.size(), result.data());
}

void Logarithms(std::span<const double> x, std::span<double> result) {
  MapLanes<LogarithmMap>({x.data()}, x.size(), result.data());
}

void Sines(std::span<const double> x, std::span<double> result) {
  MapLanes<SineMap>({x.data()}, x.size(), result.data());
}

void Arctangents(std::span<const double> y, std::span<const double> x, std::span<double> result) {
  MapLanes<ArctangentMap>({y.data(), x.data()}, x.size(), result.data());
}

}  // namespace cirque
