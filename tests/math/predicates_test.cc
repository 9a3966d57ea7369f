#include "cirque/math/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Sign of a determinant by rational Leibniz expansion: shares no code with the predicates.
template <int N>
int RationalSign(const std::array<std::array<Rational, N>, N>& m) {
  Rational determinant = 0;
  std::array<int, N> p;
  for (int i = 0; i < N; ++i) p[i] = i;
  do {
    Rational term = 1;
    for (int i = 0; i < N; ++i) {
      term *= m[i][p[i]];
      for (int j = 0; j < i; ++j) {
        if (p[j] > p[i]) term = -term;
      }
    }
    determinant += term;
  } while (std::next_permutation(p.begin(), p.end()));
  return determinant.sign();
}

int ReferenceOrientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const auto row = [](const Vector2d& p) -> std::array<Rational, 3> {
    return {1, Rational(p.x()), Rational(p.y())};
  };
  return RationalSign<3>({row(a), row(b), row(c)});
}

int ReferenceInCircle(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const auto row = [](const Vector2d& p) -> std::array<Rational, 4> {
    const Rational x(p.x()), y(p.y());
    return {x, y, x * x + y * y, 1};
  };
  return RationalSign<4>({row(a), row(b), row(c), row(d)});
}

int ReferenceOrientation3(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                          const Vector3d& d) {
  const auto row = [](const Vector3d& p) -> std::array<Rational, 4> {
    return {1, Rational(p.x()), Rational(p.y()), Rational(p.z())};
  };
  return RationalSign<4>({row(a), row(b), row(c), row(d)});
}

double MovedByUlps(double x, int ulps) {
  const double target = ulps > 0 ? HUGE_VAL : -HUGE_VAL;
  for (int i = 0; i < std::abs(ulps); ++i) x = std::nextafter(x, target);
  return x;
}

class Predicates : public ::testing::Test {
 protected:
  double Uniform() { return uniform_(random_); }
  Vector2d Random2() { return {Uniform(), Uniform()}; }
  Vector3d Random3() { return {Uniform(), Uniform(), Uniform()}; }
  /// A double of any magnitude, subnormal to nearly overflowing; zero sometimes.
  double Wild() {
    const int exponent = static_cast<int>(1070 * Uniform());
    return Uniform() < -0.8 ? 0.0 : std::ldexp(Uniform(), std::clamp(exponent, -1074, 1023));
  }

 private:
  std::mt19937_64 random_{20060701};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

TEST_F(Predicates, KnownSigns) {
  EXPECT_EQ(OrientationSign({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(OrientationSign({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(OrientationSign({0.1, 0.1}, {0.2, 0.2}, {0.7, 0.7}), 0);
  EXPECT_EQ(InCircleSign({1, 0}, {0, 1}, {-1, 0}, {0, 0}), 1);
  EXPECT_EQ(InCircleSign({1, 0}, {0, 1}, {-1, 0}, {0, -1}), 0);
  EXPECT_EQ(InCircleSign({1, 0}, {0, 1}, {-1, 0}, {0, -2}), -1);
  EXPECT_EQ(OrientationSign3({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(OrientationSign3({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
  EXPECT_EQ(OrientationSign3({0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {7, 9, 5}), 0);
}

TEST_F(Predicates, AgreeWithRationalsOnRandomPoints) {
  for (int i = 0; i < 200; ++i) {
    const Vector2d a = Random2(), b = Random2(), c = Random2(), d = Random2();
    EXPECT_EQ(OrientationSign(a, b, c), ReferenceOrientation(a, b, c));
    EXPECT_EQ(InCircleSign(a, b, c, d), ReferenceInCircle(a, b, c, d));
    const Vector3d p = Random3(), q = Random3(), r = Random3(), s = Random3();
    EXPECT_EQ(OrientationSign3(p, q, r, s), ReferenceOrientation3(p, q, r, s));
  }
}

TEST_F(Predicates, AgreeWithRationalsOnAGridOfUlpsAboutALine) {
  std::array<int, 3> seen = {};
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      const Vector2d a(MovedByUlps(0.5, i), MovedByUlps(0.5, j)), b(12, 12), c(24, 24);
      const int sign = OrientationSign(a, b, c);
      EXPECT_EQ(sign, ReferenceOrientation(a, b, c)) << i << " " << j;
      ++seen[sign + 1];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

TEST_F(Predicates, AgreeWithRationalsOnAGridOfUlpsAboutACircle) {
  std::array<int, 3> seen = {};
  const Vector2d a(25, 0), b(-7, 24), c(-20, -15);
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      const Vector2d d(MovedByUlps(7, i), MovedByUlps(-24, j));
      const int sign = InCircleSign(a, b, c, d);
      EXPECT_EQ(sign, ReferenceInCircle(a, b, c, d)) << i << " " << j;
      ++seen[sign + 1];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

TEST_F(Predicates, AgreeWithRationalsOnNearlyCoplanarPoints) {
  std::array<int, 3> seen = {};
  for (int i = 0; i < 300; ++i) {
    // d is the rounded affine combination; on the coarse grid it is exact, hence coplanar.
    const auto coarse = [&] { return std::round(64 * Uniform()) / 64; };
    const bool exact = i % 3 == 0;
    const auto point = [&] { return exact ? Vector3d(coarse(), coarse(), coarse()) : Random3(); };
    const Vector3d a = point(), b = point(), c = point();
    const Vector3d d = a + 0.25 * (b - a) + 0.5 * (c - a);
    const int sign = OrientationSign3(a, b, c, d);
    EXPECT_EQ(sign, ReferenceOrientation3(a, b, c, d));
    ++seen[sign + 1];
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

TEST_F(Predicates, ExactDegeneracyIsZeroAtEveryScale) {
  for (const int exponent : {-1070, -600, -300, 0, 300, 600, 1010}) {
    const auto at = [&](double x, double y) {
      return Vector2d(std::ldexp(x, exponent), std::ldexp(y, exponent));
    };
    EXPECT_EQ(OrientationSign(at(1, 1), at(3, 2), at(7, 4)), 0) << exponent;
    EXPECT_EQ(OrientationSign(at(1, 1), at(3, 2), at(8, 5)), 1) << exponent;
    EXPECT_EQ(InCircleSign(at(5, 0), at(3, 4), at(-4, 3), at(0, -5)), 0) << exponent;
    EXPECT_EQ(InCircleSign(at(5, 0), at(3, 4), at(-4, 3), at(0, -4)), 1) << exponent;
    EXPECT_EQ(InCircleSign(at(5, 0), at(3, 4), at(-4, 3), at(0, -6)), -1) << exponent;
  }
}

TEST_F(Predicates, AgreeWithRationalsAcrossTheWholeRangeOfDoubles) {
  for (int i = 0; i < 60; ++i) {
    const auto wild2 = [&] { return Vector2d(Wild(), Wild()); };
    const Vector2d a = wild2(), b = wild2(), c = wild2(), d = wild2();
    EXPECT_EQ(OrientationSign(a, b, c), ReferenceOrientation(a, b, c));
    EXPECT_EQ(InCircleSign(a, b, c, d), ReferenceInCircle(a, b, c, d));
    const auto wild3 = [&] { return Vector3d(Wild(), Wild(), Wild()); };
    const Vector3d p = wild3(), q = wild3(), r = wild3(), s = wild3();
    EXPECT_EQ(OrientationSign3(p, q, r, s), ReferenceOrientation3(p, q, r, s));
  }
}

TEST_F(Predicates, UnderflowInTheFilterDoesNotDecide) {
  // u x v = 2^-1074 2^-1 - 2^-1074 2^-1 + 2^-1126: every product underflows or rounds.
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Vector2d a(0, 0), b(0.5, tiny), c(std::nextafter(0.5, 0.0), tiny);
  EXPECT_EQ(OrientationSign(a, b, c), ReferenceOrientation(a, b, c));
  EXPECT_EQ(OrientationSign(a, b, c), 1);
}

TEST_F(Predicates, SwappingTwoPointsReversesTheSign) {
  for (int i = 0; i < 300; ++i) {
    // Points on a coarse grid are degenerate often.
    const auto coarse = [&] { return std::round(3 * Uniform()) * 0.1; };
    const Vector2d a(coarse(), coarse()), b(coarse(), coarse());
    const Vector2d c(coarse(), coarse()), d(coarse(), coarse());
    const int orientation = OrientationSign(a, b, c), circle = InCircleSign(a, b, c, d);
    EXPECT_EQ(OrientationSign(b, a, c), -orientation);
    EXPECT_EQ(OrientationSign(b, c, a), orientation);
    EXPECT_EQ(InCircleSign(b, a, c, d), -circle);
    EXPECT_EQ(InCircleSign(a, b, d, c), -circle);
    EXPECT_EQ(InCircleSign(b, c, a, d), circle);
  }
}

}  // namespace
}  // namespace cirque
