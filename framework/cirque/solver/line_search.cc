#include "cirque/solver/line_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace cirque {

namespace {

constexpr int kMaxTrials = 50;
constexpr double kOvershootSlope = 0.5, kOvershootGradient = 0.9, kFarBelow = 0.25;
constexpr double kUnchangedSlope =
    0.9;  ///< a step that leaves this share of the slope was far too short

class Search {
 public:
  Search(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
         const Eigen::VectorXd& direction, SolveRun* run)
      : x_(x),
        direction_(direction),
        run_(run),
        space_(run->space()),
        slope0_(space_.Dot(gradient, direction)),
        norm0_(space_.Norm(gradient)),
        largest0_(space_.LargestEntry(gradient)),
        low_slope_(slope0_) {}

  void Run(LineSearchResult* point) {
    double t = 1;
    for (int trial = 0; trial < kMaxTrials; ++trial) {
      if (!EvaluateAt(t, point)) {
        high_ = t;
        t = low_ + 0.5 * (t - low_);
        continue;
      }
      const double slope = space_.Dot(point->gradient, direction_);
      if (slope <= 0) {
        const bool too_short = high_ == kNoBound && slope < kUnchangedSlope * slope0_;
        if (!too_short) return;
        low_ = t, low_slope_ = slope;
        std::swap(best_, *point);
        t *= 2;
      } else {
        if (AcceptableOvershoot(slope, *point)) return;
        if (best_.found) break;
        t = Cut(t, slope);
      }
    }
    std::swap(best_, *point);
  }

 private:
  static constexpr double kNoBound = -1;

  bool EvaluateAt(double t, LineSearchResult* point) {
    point->found = true;
    point->step_length = t;
    point->x = x_ + t * direction_;
    return run_->Gradient(point->x, &point->gradient);
  }

  /// Near the minimum either norm may be rounding, and the slope is where the direction has much of
  /// a gauge's kernel.
  bool AcceptableOvershoot(double slope, const LineSearchResult& point) const {
    const double left = std::min(space_.Norm(point.gradient) / norm0_,
                                 space_.LargestEntry(point.gradient) / largest0_);
    return left <= kFarBelow || (left <= kOvershootGradient && slope <= -kOvershootSlope * slope0_);
  }

  /// The next trial between low_ and t, where the slope turned positive: the secant's zero, kept
  /// off the ends.
  double Cut(double t, double slope) {
    high_ = t;
    const double fraction = low_slope_ / (low_slope_ - slope);
    return low_ + std::clamp(fraction, 0.05, 0.95) * (t - low_);
  }

  const Eigen::VectorXd& x_;
  const Eigen::VectorXd& direction_;
  SolveRun* run_;
  const ParameterSpace& space_;
  const double slope0_, norm0_, largest0_;
  double low_ = 0, low_slope_, high_ = kNoBound;
  LineSearchResult best_;
};

}  // namespace

void SearchAlong(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                 const Eigen::VectorXd& direction, SolveRun* run, LineSearchResult* result) {
  Search(x, gradient, direction, run).Run(result);
}

namespace {

constexpr int kMaxTrialsToRest = 120;
constexpr double kAtRest = 0.1;  ///< of the slope at the start
constexpr double kFurther = 4, kFurthest = 1e12, kNearer = 0.1, kWide = 10;
constexpr double kOneStep = 1e-15;  ///< of step lengths that doubles do not tell apart

/// Step lengths with the minimum between them.
struct Bracket {
  double low = 0;
  std::optional<double> high = std::nullopt;

  bool IsClosed() const { return high && *high - low <= kOneStep * *high; }

  double Next() const {
    if (!high) return kFurther * low;
    if (low == 0) return kNearer * *high;
    return *high > kWide * low ? std::sqrt(low * *high) : 0.5 * (low + *high);
  }
};

}  // namespace

void SearchToRest(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                  const Eigen::VectorXd& direction, SolveRun* run, LineSearchResult* result) {
  const ParameterSpace& space = run->space();
  const double enough = -kAtRest * space.Dot(gradient, direction);
  double least = std::numeric_limits<double>::infinity(), t = 1;
  Bracket bracket;
  LineSearchResult trial;
  result->found = false;
  for (int i = 0; i < kMaxTrialsToRest && t <= kFurthest; ++i, t = bracket.Next()) {
    trial.step_length = t;
    trial.x = x + t * direction;
    trial.found = run->Gradient(trial.x, &trial.gradient);
    const double slope = trial.found ? space.Dot(trial.gradient, direction) : 0;
    if (trial.found && slope <= 0) {
      bracket.low = t;
    } else {
      bracket.high = t;
    }
    if (trial.found && std::abs(slope) < least) {
      least = std::abs(slope);
      std::swap(*result, trial);
    }
    if (least <= enough || bracket.IsClosed()) return;
  }
}

namespace {

constexpr int kMaxTrialsAlongKinks = 40;
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
  for (int trial = 0; trial < kMaxTrialsAlongKinks && !result->found; ++trial, t *= kCut) {
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
