#include "cirque/solver/kinked_line_search.h"

#include <cmath>

namespace cirque {
namespace {

constexpr int kMaxTrials = 40;
constexpr double kCut = 0.25, kArmijo = 1e-4, kGradientFall = 0.9;
constexpr double kRounding = 1e-13;  ///< of an energy value, relative

}  // namespace

void SearchAlongKinks(const Kinks& kinks, const Eigen::VectorXd& x,
                      const Eigen::VectorXd& subgradient, const Eigen::VectorXd& direction,
                      SolveRun* run, LineSearchResult* result) {
  double start = 0;
  result->found = false;
  if (!run->Value(x.data(), &start, nullptr)) return;
  const double rounding = kRounding * (1 + std::abs(start));
  double t = 1;
  for (int trial = 0; trial < kMaxTrials && !result->found; ++trial, t *= kCut) {
    result->step_length = t;
    result->x = x + t * direction;
    kinks.StopAt(x, subgradient, &result->x);
    double value = 0;
    if (!run->Value(result->x.data(), &value, &result->gradient)) continue;
    const double expected = kArmijo * subgradient.dot(result->x - x);
    const bool enough = expected < 0 && value - start <= expected - rounding;
    const bool fell = value - start <= rounding;
    result->found =
        enough || (fell && result->gradient.norm() <= kGradientFall * subgradient.norm());
  }
}

}  // namespace cirque
