#include "cirque/math/half_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "cirque/core/types.h"
#include "cirque/math/arctangent.h"
#include "cirque/math/circle_angle.h"
#include "cirque/math/elementary_arrays.h"
#include "cirque/math/half_angle_formulas.h"
#include "cirque/math/lane_map.h"
#include "cirque/math/pi.h"

namespace cirque {
namespace {

/// d, sine and 1 - cosine of one edge.
using Edge = std::array<double, 3>;

CircleAngle AngleOf(const Edge& e) { return {0, e[1], e[2]}; }

struct HalfAngleMap {
  static constexpr std::size_t kInputs = 3;
  static bool IsOrdinary(const Edge& e) {
    // The sides of the arctangent are then no shorter than that sine, or than d.
    return std::abs(e[0]) <= kLargestExponent && e[1] > 0x1p-800;
  }
  template <class T>
  [[gnu::always_inline]] static T Of(const std::array<T, 3>& e) {
    const auto sides = SidesOfHalfAngle(e[0], e[1], e[2], DecayBy(lanes::Absolute(e[0])));
    return OrdinaryArctangent(sides.sine, sides.cosine);
  }
  static double OfOther(const Edge& e) { return HalfAngle(e[0], AngleOf(e)); }
};

struct WeightMap {
  static constexpr std::size_t kInputs = 3;
  static bool IsOrdinary(const Edge& e) { return std::abs(e[0]) <= kLargestExponent; }
  template <class T>
  [[gnu::always_inline]] static T Of(const std::array<T, 3>& e) {
    return WeightOfHalfAngle(e[1], e[2], DecayBy(lanes::Absolute(e[0])));
  }
  static double OfOther(const Edge& e) { return HalfAngleWeight(e[0], AngleOf(e)); }
};

}  // namespace

void CircleAngles(std::span<const double> alpha_i, std::span<const double> alpha_j,
                  std::span<CircleAngle> angle) {
  std::array<double, lanes::kRun> half, sine;
  for (std::size_t first = 0; first < angle.size(); first += half.size()) {
    const std::size_t count = std::min(half.size(), angle.size() - first);
    for (std::size_t k = 0; k < count; ++k) {
      const double a = alpha_i[first + k], b = alpha_j[first + k];
      const double theta = angle[first + k].theta = CircleAngle::Theta(a, b);
      half[k] = 0.5 * (theta < 0.5 * kPi ? theta : a + b);
    }
    Sines({half.data(), count}, {sine.data(), count});
    for (std::size_t k = 0; k < count; ++k) {
      // Up to pi/4, where the cosine is as accurate as the sine.
      CircleAngle& of_edge = angle[first + k];
      const double square = sine[k] * sine[k];
      of_edge.sine = 2 * sine[k] * std::sqrt(1 - square);
      of_edge.one_minus_cosine = of_edge.theta < 0.5 * kPi ? 2 * square : 2 * (1 - square);
    }
  }
}

void HalfAngles(std::span<const double> d, std::span<const double> sine,
                std::span<const double> one_minus_cosine, std::span<double> phi) {
  MapLanes<HalfAngleMap>({d.data(), sine.data(), one_minus_cosine.data()}, d.size(), phi.data());
}

void HalfAngleWeights(std::span<const double> d, std::span<const double> sine,
                      std::span<const double> one_minus_cosine, std::span<double> weight) {
  MapLanes<WeightMap>({d.data(), sine.data(), one_minus_cosine.data()}, d.size(), weight.data());
}

}  // namespace cirque
