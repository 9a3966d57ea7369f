#include "cirque/math/moebius.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace cirque {
namespace {

const ExtendedComplex kInfinity = ExtendedComplex::Infinity();

double Distance(const ExtendedComplex& z, Complex w) {
  return z.is_infinite ? HUGE_VAL : std::abs(z.value - w);
}

class MoebiusTest : public ::testing::Test {
 protected:
  Complex Point() { return {uniform_(random_), uniform_(random_)}; }
  Moebius Map() { return {Point(), Point(), Point(), Point()}; }

  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-2, 2};
};

TEST_F(MoebiusTest, CompositionIsApplicationOneAfterTheOther) {
  for (int i = 0; i < 50; ++i) {
    const Moebius f = Map(), g = Map();
    const Complex z = Point();
    const Complex wanted = f(g(z)).value;
    EXPECT_LT(Distance(f.After(g)(z), wanted), 1e-11 * (1 + std::norm(wanted)));
  }
}

TEST_F(MoebiusTest, InverseUndoes) {
  for (int i = 0; i < 50; ++i) {
    const Moebius f = Map();
    const Complex z = Point();
    EXPECT_LT(Distance(f.Inverse()(f(z)), z), 1e-11);
  }
}

TEST_F(MoebiusTest, TakesThreePointsWhereTheyShallGoInfinityToo) {
  const std::array<ExtendedComplex, 3> from[] = {{Point(), Point(), Point()},
                                                 {kInfinity, Point(), Point()},
                                                 {Point(), kInfinity, Point()},
                                                 {Point(), Point(), kInfinity}};
  for (const auto& a : from) {
    for (const auto& b : from) {
      const auto f = Moebius::FromThreePoints(a, b);
      ASSERT_TRUE(f);
      for (int k = 0; k < 3; ++k) {
        // An infinite image may be computed as a huge one: its reciprocal is judged.
        const ExtendedComplex image = (*f)(a[k]);
        if (b[k].is_infinite) {
          EXPECT_TRUE(image.is_infinite || std::abs(image.value) > 1e14);
        } else {
          EXPECT_LT(Distance(image, b[k].value), 1e-13);
        }
      }
    }
  }
}

TEST_F(MoebiusTest, CoincidingPointsHaveNoMap) {
  const std::array<ExtendedComplex, 3> good = {0.0, 1.0, kInfinity};
  EXPECT_FALSE(Moebius::FromThreePoints({2.0, 2.0, 3.0}, good));
  EXPECT_FALSE(Moebius::FromThreePoints(good, {kInfinity, 1.0, kInfinity}));
}

TEST_F(MoebiusTest, CrossRatioIsKept) {
  for (int i = 0; i < 20; ++i) {
    const Moebius f = Map();
    const Complex p = Point(), q = Point(), r = Point(), s = Point();
    const Complex before = CrossRatio(p, q, r, s).value;
    EXPECT_LT(Distance(CrossRatio(f(p), f(q), f(r), f(s)), before),
              1e-10 * (1 + std::norm(before)));
  }
}

TEST_F(MoebiusTest, CrossRatioWithInfinityIsTheLimit) {
  const Complex q(1, 2), r(-0.5, 0.25), s(3, -1);
  const Complex far(1e12, 3e11);
  EXPECT_LT(Distance(CrossRatio(kInfinity, q, r, s), CrossRatio(far, q, r, s).value), 1e-10);
  EXPECT_LT(Distance(CrossRatio(q, kInfinity, r, s), CrossRatio(q, far, r, s).value), 1e-10);
  EXPECT_LT(Distance(CrossRatio(q, r, kInfinity, s), CrossRatio(q, r, far, s).value), 1e-10);
  EXPECT_LT(Distance(CrossRatio(q, r, s, kInfinity), CrossRatio(q, r, s, far).value), 1e-10);
  EXPECT_TRUE(CrossRatio(q, r, r, s).is_infinite);
}

TEST_F(MoebiusTest, FixedPointsStay) {
  for (int i = 0; i < 20; ++i) {
    const Moebius f = Map();
    const auto fixed = f.FixedPoints();
    ASSERT_TRUE(fixed);
    for (const ExtendedComplex& z : *fixed) EXPECT_LT(Distance(f(z), z.value), 1e-10);
  }
}

TEST_F(MoebiusTest, FixedPointsOfTranslationsScalingsAndTheIdentity) {
  const auto translation = Moebius(1, 5, 0, 1).FixedPoints();
  ASSERT_TRUE(translation);
  EXPECT_EQ((*translation)[0], kInfinity);
  EXPECT_EQ((*translation)[1], kInfinity);
  const auto scaling = Moebius(3, 0, 0, 1).FixedPoints();
  ASSERT_TRUE(scaling);
  EXPECT_TRUE((*scaling)[0] == kInfinity || (*scaling)[1] == kInfinity);
  EXPECT_TRUE((*scaling)[0] == ExtendedComplex(0.0) || (*scaling)[1] == ExtendedComplex(0.0));
  EXPECT_FALSE(Moebius().FixedPoints());
  const auto parabolic = Moebius(1, 0, 1, 1).FixedPoints();  // z / (z + 1)
  ASSERT_TRUE(parabolic);
  EXPECT_EQ((*parabolic)[0], ExtendedComplex(0.0));
}

TEST_F(MoebiusTest, DiskAutomorphismKeepsTheCircleAndItsDirectionAtTheCentre) {
  const Complex a(0.6, -0.7);
  const Moebius f = Moebius::DiskAutomorphism(a);
  EXPECT_EQ(f(a), ExtendedComplex(0.0));
  for (int k = 0; k < 12; ++k) {
    EXPECT_NEAR(std::abs(f(std::polar(1.0, 0.5 * k)).value), 1, 1e-14);
  }
  const Complex ahead = f(a + 1e-6).value;
  EXPECT_GT(ahead.real(), 0);
  EXPECT_NEAR(ahead.imag() / ahead.real(), 0, 1e-4);
}

TEST_F(MoebiusTest, CayleyMapTakesTheHalfPlaneToTheDisk) {
  const Complex c(3, 0.5);
  const Moebius f = Moebius::Cayley(c);
  EXPECT_EQ(f(c), ExtendedComplex(0.0));
  EXPECT_EQ(f(kInfinity), ExtendedComplex(1.0));
  EXPECT_EQ(f(std::conj(c)), kInfinity);
  double last = -1;
  for (double x = -1e4; x < 1e4; x = x * (x < 0 ? 0.5 : 2) + (std::abs(x) < 1e-3 ? 0.01 : 0)) {
    const Complex w = f(x).value;
    EXPECT_NEAR(std::abs(w), 1, 1e-15);
    const double angle = std::arg(w) < 0 ? std::arg(w) + 2 * M_PI : std::arg(w);
    EXPECT_GT(angle, last);  // the boundary runs counter-clockwise
    last = angle;
  }
  EXPECT_LT(std::abs(f(Complex(2.9, 1)).value), 1);
}

TEST_F(MoebiusTest, HugeAndTinyPointsDoNotOverflow) {
  const Moebius f(1, 2, 3, 4);
  EXPECT_LT(Distance(f(1e300), Complex(1.0 / 3)), 1e-15);
  EXPECT_LT(Distance(f(1e-300), Complex(0.5)), 1e-15);
  EXPECT_LT(Distance(Moebius(1e-200, 2e-200, 3e-200, 4e-200)(1.0), Complex(3.0 / 7)), 1e-15);
}

}  // namespace
}  // namespace cirque
