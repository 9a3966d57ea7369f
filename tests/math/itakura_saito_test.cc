#include "cirque/math/itakura_saito.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "experiments/common/high_precision.h"

namespace cirque {
namespace {

using high_precision::Real;
using high_precision::RelativeError;

/// Both sides of 1 at all distances, both sides of the switch to the series, extremes.
std::vector<double> Arguments() {
  std::vector<double> t = {
      1e-150, 1e-12, 0.01, 0.5,  0.7, std::nextafter(0.7, 1.0), 1.3, std::nextafter(1.3, 1.0),
      2.0,    1e3,   1e12, 1e150};
  for (const double x : {0x1p-52, 1e-15, 1e-12, 1e-8, 1e-4, 1e-2, 0.1, 0.29, 0.31}) {
    t.push_back(1.0 + x);
    t.push_back(1.0 - x);
  }
  return t;
}

template <typename Jet, typename Residual, typename Reference>
void ExpectAccurate(const Jet& jet, const Residual& residual, const Reference& reference, double t,
                    const Real& slope, const Real& curvature) {
  const Real r = (t < 1.0 ? -1 : 1) * sqrt(2 * reference);
  EXPECT_LT(RelativeError(jet.value, reference), 4e-15) << t;
  EXPECT_LT(RelativeError(jet.slope, slope), 1e-15) << t;
  EXPECT_LT(RelativeError(jet.curvature, curvature), 1e-15) << t;
  EXPECT_LT(RelativeError(residual.value, r), 4e-15) << t;
  EXPECT_LT(RelativeError(residual.slope, Real(slope / r)), 4e-15) << t;
}

TEST(Divergences, AgreeWithFiftyDigits) {
  for (const double t : Arguments()) {
    const Real u = t;
    ExpectAccurate(ItakuraSaito(t), ItakuraSaitoResidual(t), Real(u - log(u) - 1), t,
                   Real(1 - 1 / u), Real(1 / (u * u)));
    ExpectAccurate(KullbackLeibler(t), KullbackLeiblerResidual(t), Real(u * log(u) - u + 1), t,
                   Real(log(u)), Real(1 / u));
  }
}

TEST(Divergences, VanishAtOneWithUnitSlopeOfTheResidual) {
  for (const auto& jet : {ItakuraSaito(1.0), KullbackLeibler(1.0)}) {
    EXPECT_EQ(jet.value, 0.0);
    EXPECT_EQ(jet.slope, 0.0);
    EXPECT_EQ(jet.curvature, 1.0);
  }
  for (const auto& r : {ItakuraSaitoResidual(1.0), KullbackLeiblerResidual(1.0)}) {
    EXPECT_EQ(r.value, 0.0);
    EXPECT_EQ(r.slope, 1.0);
  }
}

TEST(Divergences, ResidualsFollowTheirSeries) {
  for (const double x : {-1e-3, 1e-3}) {
    EXPECT_NEAR(ItakuraSaitoResidual(1.0 + x).value, x - x * x / 3 + 7 * x * x * x / 36, 1e-12);
    EXPECT_NEAR(KullbackLeiblerResidual(1.0 + x).value, x - x * x / 6 + 5 * x * x * x / 72, 1e-12);
  }
}

TEST(Divergences, EdgeOfTheDomain) {
  EXPECT_EQ(ItakuraSaito(0.0).value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(KullbackLeibler(0.0).value, 1.0);
  EXPECT_TRUE(std::isnan(ItakuraSaito(-1.0).value));
  EXPECT_TRUE(std::isnan(KullbackLeibler(-1.0).value));
  EXPECT_TRUE(std::isnan(ItakuraSaitoResidual(-1.0).value));
  EXPECT_TRUE(std::isnan(KullbackLeiblerResidual(-1.0).value));
}

}  // namespace
}  // namespace cirque
