#include "tests/energy/relaxation_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace cirque {

EnergyPoint PointAt(const Energy& energy, Eigen::VectorXd x) {
  EnergyPoint point{std::move(x), 0, Eigen::VectorXd(energy.NumParameters())};
  EXPECT_TRUE(energy.Evaluate(point.x.data(), &point.value, point.gradient.data()));
  return point;
}

bool ExpectSoundRelax(const Energy& energy, double share, const EnergyPoint& before,
                      EnergyPoint* after) {
  Eigen::VectorXd x = before.x, gradient = before.gradient;
  const bool relaxed = energy.Relax(share * before.largest(), x.data(), gradient.data());
  *after = PointAt(energy, x);
  if (!relaxed) {
    EXPECT_EQ(x, before.x);
    EXPECT_EQ(gradient, before.gradient);
    return false;
  }
  // The value is a sum of terms about as large as the parameters.
  const double rounding = 1e-13 * (1 + std::abs(before.value) + before.x.lpNorm<1>());
  EXPECT_LE(after->value, before.value + rounding);
  const double error = (gradient - after->gradient).lpNorm<Eigen::Infinity>();
  EXPECT_LE(error, 1e-12 * std::max(1.0, before.largest()));
  return true;
}

}  // namespace cirque
