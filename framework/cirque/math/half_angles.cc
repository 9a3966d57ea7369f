#include "cirque/math/half_angles.h"

#include <array>
#include <cmath>

#include "cirque/math/arctangent.h"
#include "cirque/math/circle_angle.h"
#include "cirque/math/half_angle_formulas.h"
#include "cirque/math/lane_map.h"

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
  static double OfAny(const Edge& e) { return HalfAngle(e[0], AngleOf(e)); }
};

struct WeightMap {
  static constexpr std::size_t kInputs = 3;
  static bool IsOrdinary(const Edge& e) { return std::abs(e[0]) <= kLargestExponent; }
  template <class T>
  [[gnu::always_inline]] static T Of(const std::array<T, 3>& e) {
    return WeightOfHalfAngle(e[1], e[2], DecayBy(lanes::Absolute(e[0])));
  }
  static double OfAny(const Edge& e) { return HalfAngleWeight(e[0], AngleOf(e)); }
};

}  // namespace

void HalfAngles(std::span<const double> d, std::span<const double> sine,
                std::span<const double> one_minus_cosine, std::span<double> phi) {
  MapLanes<HalfAngleMap>({d.data(), sine.data(), one_minus_cosine.data()}, d.size(), phi.data());
}

void HalfAngleWeights(std::span<const double> d, std::span<const double> sine,
                      std::span<const double> one_minus_cosine, std::span<double> weight) {
  MapLanes<WeightMap>({d.data(), sine.data(), one_minus_cosine.data()}, d.size(), weight.data());
}

}  // namespace cirque
