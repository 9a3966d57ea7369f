#include "cirque/math/similarity.h"

#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/core/types.h"

namespace cirque {
namespace {

using Eigen::Vector2d;

std::vector<Vector2d> RandomPoints(int count) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  std::vector<Vector2d> points;
  for (int i = 0; i < count; ++i) points.emplace_back(normal(random), normal(random));
  return points;
}

TEST(Similarity, IsFoundExactly) {
  const std::complex<double> factor = std::polar(2.5, 1.2), shift(40, -7);
  const std::vector<Vector2d> from = RandomPoints(30);
  std::vector<Vector2d> to;
  for (const Vector2d& p : from) {
    const std::complex<double> z = factor * std::complex<double>(p.x(), p.y()) + shift;
    to.emplace_back(z.real(), z.imag());
  }
  const SimilarityFit found = FitSimilarity(from, to);
  EXPECT_LT(std::abs(found.similarity.factor - factor), 1e-13);
  EXPECT_LT(std::abs(found.similarity(0) - shift), 1e-13);
  EXPECT_LT(found.max_error, 1e-14);
}

TEST(Similarity, LeavesAReflectionItsErrorAndIsOptimal) {
  const std::vector<Vector2d> from = RandomPoints(30);
  std::vector<Vector2d> to = from;
  for (Vector2d& p : to) p.x() = -p.x();
  const SimilarityFit found = FitSimilarity(from, to);
  EXPECT_GT(found.rms_error, 0.05);
  EXPECT_GT(found.max_error, found.rms_error);
  const auto squares = [&](std::complex<double> factor, std::complex<double> shift) {
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const std::complex<double> z(from[i].x(), from[i].y()), w(to[i].x(), to[i].y());
      sum += std::norm(factor * z + shift - w);
    }
    return sum;
  };
  const std::complex<double> factor = found.similarity.factor, shift = found.similarity(0);
  const double least = squares(factor, shift);
  for (const std::complex<double> step :
       {std::complex<double>(1e-3, 0), {0, 1e-3}, {-1e-3, 0}, {0, -1e-3}}) {
    EXPECT_LT(least, squares(factor + step, shift));
    EXPECT_LT(least, squares(factor, shift + step));
  }
}

TEST(Similarity, OneDisplacedPointIsTheLargestError) {
  // A thousand points on the unit circle, one of them moved by 0.1: twice the extent is about 2.2.
  std::vector<Vector2d> from, to;
  for (int i = 0; i < 1000; ++i) {
    from.emplace_back(std::cos(2 * kPi * i / 1000), std::sin(2 * kPi * i / 1000));
  }
  to = from;
  to[0].x() += 0.1;
  const SimilarityFit found = FitSimilarity(from, to);
  EXPECT_NEAR(found.max_error, 0.1 / 2.2, 2e-4);
  EXPECT_NEAR(found.rms_error, 0.1 / 2.2 / std::sqrt(1000.0), 1e-5);
}

}  // namespace
}  // namespace cirque
