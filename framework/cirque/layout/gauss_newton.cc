#include "cirque/layout/gauss_newton.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "cirque/layout/sliding.h"
#include "cirque/layout/step_system.h"
#include "cirque/layout/stretch_system.h"
#include "cirque/linear/hermitian_cholesky.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

constexpr int kSeamRounds = 12;          ///< the most; two or three take all digits off most gaps
constexpr double kSeamDecrease = 0.25;   ///< of the violation squared, that a round must bring
constexpr double kSeamTolerance = 4e-9;  ///< of a seam edge: how much its two sides may differ
constexpr double kShortestStep = 1e-10;  ///< of a line search; a face of ratio q asks for 1 / q^2
constexpr double kSufficient = 1e-4;     ///< share of the predicted decrease that a step must bring
/// Of the diagonal, a hundredfold where it does not do. With less, rounding decides how far
/// near-conformal modes move; with more, long limbs stay as they are.
constexpr double kShift = 1e-11;
constexpr double kLargestShift = 1e-8;
constexpr double kFarthestSlide = 1;  ///< [rad] on the unit circle: neighbours stay in order

/// A BeltramiSystem with what factors it.
class ConformalSystem final : public StepSystem {
 public:
  ConformalSystem(const MapPart& part, const MapObjective& objective) : system_(part, objective) {
    if (!part.rails.empty()) sliding_.emplace(part.rails, part.unknowns);
  }

  double Value(const Eigen::VectorXcd& z) const override { return system_.Value(z); }

  bool Factorize(const Eigen::VectorXcd& z, double shift) override {
    system_.Linearize(z, shift);
    if (!sliding_) return cholesky_.Factorize(system_.lower());
    std::vector<std::complex<double>> tangents;
    for (const Rail& rail : system_.part().rails) tangents.push_back(rail.Tangent(z[rail.vertex]));
    return sliding_->Factorize(system_.lower(), std::move(tangents));
  }

  Eigen::VectorXcd Solve(const Eigen::VectorXcd& right_side) const override {
    return sliding_ ? sliding_->Solve(right_side) : cholesky_.Solve(right_side);
  }

  const Eigen::VectorXcd& gradient() const override { return system_.gradient(); }
  const Eigen::VectorXd& penalty() const override { return system_.penalty(); }
  double LongestStep(const Eigen::VectorXcd& /*z*/,
                     const Eigen::VectorXcd& /*direction*/) const override {
    return 1;
  }

 private:
  BeltramiSystem system_;
  HermitianCholesky cholesky_;
  std::optional<SlidingCholesky> sliding_;  ///< where vertices slide
};

class Stepper {
 public:
  Stepper(const MapPart& part, StepSystem* system, Eigen::VectorXcd z)
      : part_(part),
        system_(*system),
        z_(std::move(z)),
        value_(system_.Value(z_)),
        seam_tolerance_(std::max(kSeamTolerance, SeamError(z_))) {}

  double value() const { return value_; }
  const Eigen::VectorXcd& z() const { return z_; }

  /// False when no step lowers the objective in floating point.
  bool Step() {
    if (!std::isfinite(value_) || !Factorize()) return false;
    const Eigen::VectorXcd direction = Direction();
    // The objective's derivative along the direction is that of the model, by its weight.
    const double slope = system_.gradient().dot(direction).real();
    if (!direction.allFinite() || !(slope < 0)) return false;
    const double longest = LongestStep(direction);
    for (double length = std::min(longest, 1.0); length > kShortestStep; length /= 2) {
      Trial trial = At(length, direction);
      const bool lower =
          trial.value < value_ && trial.value <= value_ + kSufficient * length * slope;
      if (!lower || !IsAdmissible(trial.z)) continue;
      if (length == 1) Lengthen(longest, direction, &trial);
      z_ = std::move(trial.z);
      value_ = trial.value;
      return true;
    }
    return false;
  }

 private:
  struct Trial {
    Eigen::VectorXcd z;
    double value;
  };

  Trial At(double length, const Eigen::VectorXcd& direction) const {
    Eigen::VectorXcd next = z_;
    next.head(part_.unknowns) += length * direction;
    SlideBy(length, direction, &next);
    const double value = system_.Value(next);
    return {std::move(next), value};
  }

  bool IsAdmissible(const Eigen::VectorXcd& z) const {
    return KeepsOrientation(z) && SeamError(z) <= seam_tolerance_ &&
           !(part_.fence && part_.fence->IsCrossed(z));
  }

  /// Doubles a whole step as long as that lowers the value more.
  void Lengthen(double longest, const Eigen::VectorXcd& direction, Trial* trial) const {
    for (double length = 2; length <= longest; length *= 2) {
      Trial further = At(length, direction);
      if (!(further.value < trial->value) || !IsAdmissible(further.z)) return;
      *trial = std::move(further);
    }
  }

  bool Factorize() {
    for (double shift = kShift; shift <= kLargestShift; shift *= 100) {
      if (system_.Factorize(z_, shift)) return true;
    }
    return false;
  }

  /// How far along its rail a vertex goes.
  double Slide(const Rail& rail, const Eigen::VectorXcd& direction) const {
    return std::real(std::conj(rail.Tangent(z_[rail.vertex])) * direction[rail.vertex]);
  }

  double LongestStep(const Eigen::VectorXcd& direction) const {
    double longest = system_.LongestStep(z_, direction);
    for (const Rail& rail : part_.rails) {
      const double slide = rail.IsCircle() ? std::abs(Slide(rail, direction)) : 0;
      if (slide * longest > kFarthestSlide) longest = kFarthestSlide / slide;
    }
    return longest;
  }

  void SlideBy(double length, const Eigen::VectorXcd& direction, Eigen::VectorXcd* next) const {
    for (const Rail& rail : part_.rails) {
      (*next)[rail.vertex] = rail.Move(z_[rail.vertex], length * Slide(rail, direction));
    }
  }

  /// The model's minimum among the steps that close the seams: rounds of multipliers, until they
  /// bring nothing.
  Eigen::VectorXcd Direction() {
    const auto count = static_cast<Eigen::Index>(part_.seams.size());
    Eigen::VectorXcd multiplier = Eigen::VectorXcd::Zero(count);
    Eigen::VectorXcd open = Violation(z_), step, whole = Eigen::VectorXcd::Zero(z_.size());
    double violation = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kSeamRounds; ++round) {
      step = system_.Solve(PulledGradient(multiplier, open));
      if (count == 0) break;
      whole.head(part_.unknowns) = step;
      const Eigen::VectorXcd left = open + Violation(whole);
      const Eigen::VectorXcd force = system_.penalty().cwiseProduct(left);
      const double remaining = std::abs(force.dot(left));
      if (!(remaining < kSeamDecrease * violation)) break;
      violation = remaining;
      multiplier += force;
    }
    return step;
  }

  Eigen::VectorXcd Violation(const Eigen::VectorXcd& z) const {
    Eigen::VectorXcd violation(static_cast<Eigen::Index>(part_.seams.size()));
    for (Eigen::Index c = 0; c < violation.size(); ++c) violation[c] = part_.seams[c](z);
    return violation;
  }

  /// The largest violation, relative to the edge.
  double SeamError(const Eigen::VectorXcd& z) const {
    double worst = 0;
    for (const SeamConstraint& seam : part_.seams) {
      const double right = std::abs(z[seam.vertex[0]] - z[seam.vertex[1]]);
      const double left = std::abs(z[seam.vertex[2]] - z[seam.vertex[3]]);
      worst = std::max(worst, std::abs(seam(z)) / std::max(left, right));
    }
    return worst;
  }

  /// -gradient - C* (multiplier + P open), the right side of a round.
  Eigen::VectorXcd PulledGradient(const Eigen::VectorXcd& multiplier,
                                  const Eigen::VectorXcd& open) const {
    Eigen::VectorXcd result = -system_.gradient();
    for (Eigen::Index c = 0; c < multiplier.size(); ++c) {
      const SeamConstraint& seam = part_.seams[c];
      const std::complex<double> pull = multiplier[c] + system_.penalty()[c] * open[c];
      for (int k = 0; k < 4; ++k) {
        if (seam.vertex[k] >= part_.unknowns) continue;
        result[seam.vertex[k]] -= std::conj(seam.factor[k]) * pull;
      }
    }
    return result;
  }

  /// Of all triangles, and of the boundary's edges along their rails.
  bool KeepsOrientation(const Eigen::VectorXcd& z) const {
    const auto runs = [&](const RimEdge& edge) {
      return edge.RunsBetween(z[edge.tail], z[edge.tip]);
    };
    if (!std::all_of(part_.rim.begin(), part_.rim.end(), runs)) return false;
    const auto at = [&](Index v) { return Eigen::Vector2d(z[v].real(), z[v].imag()); };
    return std::all_of(part_.triangles.begin(), part_.triangles.end(), [&](const auto& corner) {
      return OrientationSign(at(corner[0]), at(corner[1]), at(corner[2])) > 0;
    });
  }

  const MapPart& part_;
  StepSystem& system_;
  Eigen::VectorXcd z_;
  double value_;
  double seam_tolerance_;
};

/// Steps on a part of z by a system of that part.
int Lower(const MapPart& part, StepSystem* system, const StepLimits& limits,
          const std::atomic<bool>* cancelled, Eigen::VectorXcd* z) {
  Eigen::VectorXcd start(static_cast<Eigen::Index>(part.vertex.size()));
  for (Eigen::Index i = 0; i < start.size(); ++i) start[i] = (*z)[part.vertex[i]];
  Stepper stepper(part, system, std::move(start));
  int steps = 0;
  while (steps < limits.steps && !(cancelled && *cancelled)) {
    const double before = stepper.value();
    if (!stepper.Step()) break;
    ++steps;
    if (before - stepper.value() <= limits.decrease * stepper.value()) break;
  }
  for (Index i = 0; steps > 0 && i < part.unknowns; ++i) (*z)[part.vertex[i]] = stepper.z()[i];
  return steps;
}

}  // namespace

int LowerObjective(const MapPart& part, const MapObjective& objective, const StepLimits& limits,
                   const std::atomic<bool>* cancelled, Eigen::VectorXcd* z) {
  if (part.unknowns == 0) return 0;
  ConformalSystem system(part, objective);
  return Lower(part, &system, limits, cancelled, z);
}

int LowerStretch(const MapPart& part, const StretchEnergy& energy, double unit,
                 const StepLimits& limits, const std::atomic<bool>* cancelled,
                 Eigen::VectorXcd* z) {
  if (part.unknowns == 0) return 0;
  StretchSystem system(part, energy, unit);
  return Lower(part, &system, limits, cancelled, z);
}

}  // namespace cirque
