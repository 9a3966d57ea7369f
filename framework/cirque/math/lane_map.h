#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "cirque/core/lanes.h"

namespace cirque {

namespace lanes {

/// Places that are ordinary or not together.
constexpr std::size_t kRun = 64;

template <class Function>
using Inputs = std::array<const double*, Function::kInputs>;

template <class T, std::size_t N>
[[gnu::always_inline]] inline std::array<T, N> Load(const std::array<const double*, N>& in,
                                                    std::size_t place) {
  std::array<T, N> x;
  for (std::size_t k = 0; k < N; ++k) std::memcpy(&x[k], in[k] + place, sizeof(T));
  return x;
}

template <class Function>
[[gnu::always_inline]] inline void MapRun(const Inputs<Function>& in, std::size_t begin,
                                          std::size_t end, double* out) {
  bool ordinary = true;
  for (std::size_t i = begin; i < end; ++i) {
    ordinary &= Function::IsOrdinary(Load<double>(in, i));
  }
  for (; ordinary && begin + kLanes <= end; begin += kLanes) {
    const Lanes result = Function::Of(Load<Lanes>(in, begin));
    std::memcpy(out + begin, &result, sizeof(result));
  }
  for (; begin < end; ++begin) {
    const auto x = Load<double>(in, begin);
    out[begin] = Function::IsOrdinary(x) ? Function::Of(x) : Function::OfOther(x);
  }
}

}  // namespace lanes

/// A function of N numbers at every place of N arrays, kLanes places at a time. `Function` has
///   static constexpr std::size_t kInputs;                              N
///   static bool IsOrdinary(const std::array<double, N>& x);            what Of is made for
///   template <class T> static T Of(const std::array<T, N>& x);         of doubles or Lanes
///   static double OfOther(const std::array<double, N>& x);             of what is not ordinary
template <class Function>
void MapLanes(const lanes::Inputs<Function>& in, std::size_t n, double* out) {
  OnWideLanes([&]() __attribute__((always_inline)) {
    for (std::size_t i = 0; i < n; i += lanes::kRun) {
      lanes::MapRun<Function>(in, i, std::min(n, i + lanes::kRun), out);
    }
  });
}

}  // namespace cirque
