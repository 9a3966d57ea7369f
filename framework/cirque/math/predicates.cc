#include "cirque/math/predicates.h"

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cmath>
#include <optional>

#include <glog/logging.h>

#include "cirque/math/exact_integer.h"

namespace cirque {
namespace {

constexpr double kHalfUlp = 0x1p-53;
/// Bounds what the underflow of a few products can add to a determinant of factors near 1.
constexpr double kUnderflow = 0x1p-1060;

/// The sign of `determinant` where its error bound leaves it certain. Overflow makes the bound
/// infinite or NaN and so comes out undecided.
std::optional<int> FilteredSign(double determinant, double bound) {
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return std::nullopt;
}

/// A 3x3 determinant expanded along a column, with the sum of absolute values that bounds its
/// error.
class FilteredSum {
 public:
  void Add(double factor, double left, double right) {
    const double magnitude = std::abs(factor);
    determinant_ += factor * (left - right);
    permanent_ += magnitude * (std::abs(left) + std::abs(right));
    largest_ = std::max(largest_, magnitude);
  }
  std::optional<int> Sign(double half_ulps) const {
    return FilteredSign(determinant_, half_ulps * kHalfUlp * permanent_ + kUnderflow * largest_);
  }

 private:
  double determinant_ = 0.0, permanent_ = 0.0, largest_ = 1.0;
};

/// x = mantissa * 2^exponent, mantissa odd (or 0).
struct Dyadic {
  explicit Dyadic(double x) {
    CHECK(std::isfinite(x)) << "exact predicates need finite coordinates";
    if (x == 0.0) return;
    mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    mantissa >>= zeros;
    exponent += zeros - 53;
  }
  std::int64_t mantissa = 0;
  int exponent = INT_MAX;
};

/// All coordinates times one common power of two that makes them integers: the signs of homogeneous
/// polynomials stay what they were.
template <std::size_t N>
std::array<ExactInteger, N> ToIntegers(const std::array<double, N>& coordinates) {
  int least = INT_MAX;
  for (const double x : coordinates) least = std::min(least, Dyadic(x).exponent);
  std::array<ExactInteger, N> integers;
  for (std::size_t i = 0; i < N; ++i) {
    const Dyadic x(coordinates[i]);
    if (x.mantissa != 0) integers[i] = ExactInteger(x.mantissa, x.exponent - least);
  }
  return integers;
}

/// a b - c d.
template <typename T>
T Cross(const T& a, const T& b, const T& c, const T& d) {
  return a * b - c * d;
}

int ExactOrientationSign(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const Eigen::Vector2d& c) {
  const auto x = ToIntegers<6>({a.x(), a.y(), b.x(), b.y(), c.x(), c.y()});
  return Cross(x[2] - x[0], x[5] - x[1], x[3] - x[1], x[4] - x[0]).Sign();
}

int ExactInCircleSign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                      const Eigen::Vector2d& d) {
  const auto x = ToIntegers<8>({a.x(), a.y(), b.x(), b.y(), c.x(), c.y(), d.x(), d.y()});
  const ExactInteger ax = x[0] - x[6], ay = x[1] - x[7];
  const ExactInteger bx = x[2] - x[6], by = x[3] - x[7];
  const ExactInteger cx = x[4] - x[6], cy = x[5] - x[7];
  return ((ax * ax + ay * ay) * Cross(bx, cy, by, cx) +
          (bx * bx + by * by) * Cross(cx, ay, cy, ax) + (cx * cx + cy * cy) * Cross(ax, by, ay, bx))
      .Sign();
}

int ExactOrientationSign3(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  const auto x = ToIntegers<12>(
      {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z(), d.x(), d.y(), d.z()});
  const ExactInteger bx = x[3] - x[0], by = x[4] - x[1], bz = x[5] - x[2];
  const ExactInteger cx = x[6] - x[0], cy = x[7] - x[1], cz = x[8] - x[2];
  const ExactInteger dx = x[9] - x[0], dy = x[10] - x[1], dz = x[11] - x[2];
  return (bx * Cross(cy, dz, cz, dy) + cx * Cross(dy, bz, dz, by) + dx * Cross(by, cz, bz, cy))
      .Sign();
}

}  // namespace

int OrientationSign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  const double left = u.x() * v.y(), right = u.y() * v.x();
  const double bound = 3.1 * kHalfUlp * (std::abs(left) + std::abs(right)) + kUnderflow;
  const std::optional<int> sign = FilteredSign(left - right, bound);
  return sign ? *sign : ExactOrientationSign(a, b, c);
}

int InCircleSign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                 const Eigen::Vector2d& d) {
  const Eigen::Vector2d u = a - d, v = b - d, w = c - d;
  FilteredSum sum;
  sum.Add(u.squaredNorm(), v.x() * w.y(), v.y() * w.x());
  sum.Add(v.squaredNorm(), w.x() * u.y(), w.y() * u.x());
  sum.Add(w.squaredNorm(), u.x() * v.y(), u.y() * v.x());
  const std::optional<int> sign = sum.Sign(10.1);
  return sign ? *sign : ExactInCircleSign(a, b, c, d);
}

int OrientationSign3(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& d) {
  const Eigen::Vector3d u = b - a, v = c - a, w = d - a;
  FilteredSum sum;
  sum.Add(u.x(), v.y() * w.z(), v.z() * w.y());
  sum.Add(v.x(), w.y() * u.z(), w.z() * u.y());
  sum.Add(w.x(), u.y() * v.z(), u.z() * v.y());
  const std::optional<int> sign = sum.Sign(7.1);
  return sign ? *sign : ExactOrientationSign3(a, b, c, d);
}

}  // namespace cirque
