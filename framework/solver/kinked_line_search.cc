#include "cirque/solver/kinked_line_search.h"

#include <cmath>

namespace cirque {
namespace {

constexpr int kMaxTrials = 40;
constexpr double kCut = 0.25, kArmijo = 1e-4, kGradientFall = 0.9;
constexpr double kRounding = 1e-13;  ///< of an energy value, relative

}  // namespace

LineSearchResult SearchAlongKinks(const Kinks& kinks, const Eigen::VectorXd& x,
                                  const Eigen::VectorXd& subgradient,
                                  const Eigen::VectorXd& direction, SolveRun* run) {
  double start = 0;
  if (!run->Value(x.data(), &start, nullptr)) return {};
  const double rounding = kRounding * (1 + std::abs(start));
  double t = 1;
  for (int trial = 0; trial < kMaxTrials; ++trial, t *= kCut) {
    LineSearchResult point{true, t, x + t * direction, {}};
    kinks.StopAt(x, subgradient, &point.x);
    double value = 0;
    if (!run->Value(point.x.data(), &value, &point.gradient)) continue;
    const double expected = kArmijo * subgradient.dot(point.x - x);
    if (expected < 0 && value - start <= expected - rounding) return point;
    const bool fell = value - start <= rounding;
    if (fell && point.gradient.norm() <= kGradientFall * subgradient.norm()) return point;
  }
  return {};
}

}  // namespace cirque
