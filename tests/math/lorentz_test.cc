#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/math/moebius.h"

#include "experiments/common/high_precision.h"

namespace cirque {
namespace {

using Eigen::Vector3d;
using high_precision::Real;

class Lorentz : public ::testing::Test {
 protected:
  Vector3d RandomUnit() {
    return Vector3d(normal_(random_), normal_(random_), normal_(random_)).normalized();
  }

 private:
  std::mt19937_64 random_{5};
  std::normal_distribution<double> normal_;
};

/// The distance from `image` to v'/v4' by the matrix form in 50 digits; v made a unit vector there.
double BoostError(const Vector3d& x, const Vector3d& v, const Vector3d& image) {
  Real xx = 0, vv = 0, vx = 0;
  for (int k = 0; k < 3; ++k) {
    xx += Real(x[k]) * x[k];
    vv += Real(v[k]) * v[k];
    vx += Real(v[k]) * x[k];
  }
  const Real norm = sqrt(vv), x4 = 1 / sqrt(1 - xx), vs = x4 * vx / norm;
  Real error = 0;
  for (int k = 0; k < 3; ++k) {
    const Real boosted = (v[k] / norm + (vs / (x4 + 1) - 1) * x4 * x[k]) / (x4 - vs);
    error += (boosted - image[k]) * (boosted - image[k]);
  }
  return static_cast<double>(sqrt(error));
}

TEST_F(Lorentz, AgreesWithTheMatrixFormInFiftyDigits) {
  for (const double gap : {1.0, 0.5, 1e-2, 1e-5, 1e-8}) {
    for (int i = 0; i < 50; ++i) {
      const Vector3d direction = RandomUnit(), x = (1.0 - gap) * direction;
      // Rounding x itself moves the image by ulp / gap.
      const double tolerance = 1e-15 / gap + 1e-15;
      const LorentzBoost boost(x);
      const Vector3d near = (direction + gap * RandomUnit()).normalized();
      for (const Vector3d& v : {RandomUnit(), near, direction, Vector3d(-direction)}) {
        EXPECT_LT(BoostError(x, v, boost(v)), tolerance) << gap;
        EXPECT_NEAR(boost(v).norm(), 1.0, 3e-16);
      }
    }
  }
}

TEST_F(Lorentz, OppositeBoostUndoesIt) {
  for (const double length : {1e-12, 0.1, 0.9}) {
    const Vector3d x = length * RandomUnit(), v = RandomUnit();
    EXPECT_LT((LorentzBoost(-x)(LorentzBoost(x)(v)) - v).norm(), 1e-14);
  }
  const Vector3d v = RandomUnit();
  EXPECT_LT((LorentzBoost(Vector3d::Zero())(v) - v).norm(), 3e-16);
}

/// Moebius transformations keep (ac)(bd) / (ad)(bc) of chord lengths.
TEST_F(Lorentz, KeepsCrossRatios) {
  const auto cross_ratio = [](const Vector3d& a, const Vector3d& b, const Vector3d& c,
                              const Vector3d& d) {
    return (a - c).norm() * (b - d).norm() / ((a - d).norm() * (b - c).norm());
  };
  for (int i = 0; i < 50; ++i) {
    const LorentzBoost boost(0.7 * RandomUnit());
    const Vector3d a = RandomUnit(), b = RandomUnit(), c = RandomUnit(), d = RandomUnit();
    EXPECT_NEAR(cross_ratio(boost(a), boost(b), boost(c), boost(d)) / cross_ratio(a, b, c, d), 1.0,
                1e-13);
  }
}

/// In Klein's ball the boost is projective: it keeps chords and carries x to the centre.
TEST_F(Lorentz, CarriesTheMidpointOfAChordToTheCentre) {
  const Vector3d axis = RandomUnit(), other = axis.unitOrthogonal();
  const Vector3d a = 0.6 * axis + 0.8 * other, b = 0.6 * axis - 0.8 * other;
  const LorentzBoost boost(0.6 * axis);
  EXPECT_LT((boost(a) + boost(b)).norm(), 1e-15);
}

TEST(LorentzDeathTest, RefusesVectorsOutsideTheBall) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(LorentzBoost(Vector3d(1, 0, 0)), "inside the unit ball");
}

}  // namespace
}  // namespace cirque
