#include "cirque/layout/gauss_newton.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

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

class Stepper {
 public:
  Stepper(const MapPart& part, const MapObjective& objective, Eigen::VectorXcd z)
      : part_(part),
        system_(part, objective),
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
    Eigen::VectorXcd next = z_;
    for (double length = 1; length > kShortestStep; length /= 2) {
      next.head(part_.unknowns) = z_.head(part_.unknowns) + length * direction;
      const double value = system_.Value(next);
      const bool lower = value < value_ && value <= value_ + kSufficient * length * slope;
      if (!lower || !KeepsOrientation(next) || !(SeamError(next) <= seam_tolerance_)) continue;
      z_ = std::move(next);
      value_ = value;
      return true;
    }
    return false;
  }

 private:
  bool Factorize() {
    for (double shift = kShift; shift <= kLargestShift; shift *= 100) {
      system_.Linearize(z_, shift);
      if (cholesky_.Factorize(system_.lower())) return true;
    }
    return false;
  }

  /// The model's minimum among the steps that close the seams: rounds of multipliers, until they
  /// bring nothing.
  Eigen::VectorXcd Direction() {
    const auto count = static_cast<Eigen::Index>(part_.seams.size());
    Eigen::VectorXcd multiplier = Eigen::VectorXcd::Zero(count);
    Eigen::VectorXcd open = Violation(z_), step, whole = Eigen::VectorXcd::Zero(z_.size());
    double violation = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kSeamRounds; ++round) {
      step = cholesky_.Solve(PulledGradient(multiplier, open));
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

  bool KeepsOrientation(const Eigen::VectorXcd& z) const {
    const auto at = [&](Index v) { return Eigen::Vector2d(z[v].real(), z[v].imag()); };
    return std::all_of(part_.triangles.begin(), part_.triangles.end(), [&](const auto& corner) {
      return OrientationSign(at(corner[0]), at(corner[1]), at(corner[2])) > 0;
    });
  }

  const MapPart& part_;
  BeltramiSystem system_;
  HermitianCholesky cholesky_;
  Eigen::VectorXcd z_;
  double value_;
  double seam_tolerance_;
};

}  // namespace

int LowerObjective(const MapPart& part, const MapObjective& objective, const StepLimits& limits,
                   const std::atomic<bool>* cancelled, Eigen::VectorXcd* z) {
  if (part.unknowns == 0) return 0;
  Eigen::VectorXcd start(static_cast<Eigen::Index>(part.vertex.size()));
  for (Eigen::Index i = 0; i < start.size(); ++i) start[i] = (*z)[part.vertex[i]];
  Stepper stepper(part, objective, std::move(start));
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

}  // namespace cirque
