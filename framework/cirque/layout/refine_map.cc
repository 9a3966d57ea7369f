#include "cirque/layout/refine_map.h"

#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

#include "cirque/layout/beltrami_system.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

constexpr int kSeamRounds = 12;         ///< the most; two or three take all digits off most gaps
constexpr double kSeamDecrease = 0.25;  ///< of the violation squared, that a round must bring
constexpr double kShortestStep = 1e-5;  ///< of a line search
constexpr double kSufficient = 1e-4;    ///< share of the predicted decrease that a step must bring

/// Where the image spans more orders of magnitude than doubles hold digits, seams would open.
constexpr double kSeamTolerance = 1e-8;

class Refiner {
 public:
  Refiner(const Triangulation& open, BeltramiSystem* system, Eigen::VectorXcd z)
      : open_(open),
        constraints_(system->constraints()),
        system_(*system),
        z_(std::move(z)),
        value_(system->Value(z_)) {}

  double value() const { return value_; }
  const Eigen::VectorXcd& z() const { return z_; }

  /// False when no step lowers the objective in floating point.
  bool Step() {
    system_.Linearize(z_);
    if (!cholesky_.Factorize(system_.lower())) return false;
    const Eigen::VectorXcd direction = Direction();
    // The objective's derivative along the direction is that of the model, by its weight.
    const double slope = system_.gradient().dot(direction).real();
    if (!direction.allFinite() || !(slope < 0)) return false;
    for (double length = 1; length > kShortestStep; length /= 2) {
      const Eigen::VectorXcd next = z_ + length * direction;
      const double value = system_.Value(next);
      if (value <= value_ + kSufficient * length * slope && KeepsOrientation(next)) {
        if (SeamError(next) > kSeamTolerance) return false;
        z_ = next;
        value_ = value;
        return true;
      }
    }
    return false;
  }

 private:
  /// The model's minimum among the steps that close the seams: rounds of multipliers, until they
  /// bring nothing.
  Eigen::VectorXcd Direction() const {
    const auto count = static_cast<Eigen::Index>(constraints_.size());
    Eigen::VectorXcd multiplier = Eigen::VectorXcd::Zero(count);
    Eigen::VectorXcd open = Violation(z_), step;
    double violation = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kSeamRounds; ++round) {
      step = cholesky_.Solve(PulledGradient(multiplier, open));
      if (count == 0) break;
      const Eigen::VectorXcd left = open + Violation(step);
      const Eigen::VectorXcd force = system_.penalty().cwiseProduct(left);
      const double remaining = std::abs(force.dot(left));
      if (!(remaining < kSeamDecrease * violation)) break;
      violation = remaining;
      multiplier += force;
    }
    return step;
  }

  Eigen::VectorXcd Violation(const Eigen::VectorXcd& z) const {
    Eigen::VectorXcd violation(static_cast<Eigen::Index>(constraints_.size()));
    for (Eigen::Index c = 0; c < violation.size(); ++c) violation[c] = constraints_[c](z);
    return violation;
  }

  /// The largest violation, relative to the size of the image.
  double SeamError(const Eigen::VectorXcd& z) const {
    if (constraints_.empty()) return 0;
    return Violation(z).cwiseAbs().maxCoeff() / (z.array() - z[0]).abs().maxCoeff();
  }

  /// -gradient - C* (multiplier + P open), the right side of a round.
  Eigen::VectorXcd PulledGradient(const Eigen::VectorXcd& multiplier,
                                  const Eigen::VectorXcd& open) const {
    Eigen::VectorXcd result = -system_.gradient();
    for (Eigen::Index c = 0; c < multiplier.size(); ++c) {
      const SeamConstraint& seam = constraints_[c];
      const std::complex<double> pull = multiplier[c] + system_.penalty()[c] * open[c];
      for (int k = 0; k < 4; ++k) result[seam.vertex[k]] -= std::conj(seam.factor[k]) * pull;
    }
    return result;
  }

  bool KeepsOrientation(const Eigen::VectorXcd& z) const {
    for (Index h = 0; h < open_.num_halfedges(); h += 3) {
      const auto at = [&](Index corner) {
        const std::complex<double> p = z[open_.vertex[corner]];
        return Eigen::Vector2d(p.real(), p.imag());
      };
      if (OrientationSign(at(h), at(h + 1), at(h + 2)) <= 0) return false;
    }
    return true;
  }

  const Triangulation& open_;
  const std::vector<SeamConstraint>& constraints_;
  BeltramiSystem& system_;
  HermitianCholesky cholesky_;
  Eigen::VectorXcd z_;
  double value_;
};

Eigen::VectorXcd PositionsOf(const Triangulation& open, const CornerUv& uv) {
  Eigen::VectorXcd z(open.num_vertices);
  for (Index c = 0; c < open.num_halfedges(); ++c) {
    z[open.vertex[c]] = {uv.value[c].x(), uv.value[c].y()};
  }
  return z;
}

double ImageArea(const CornerUv& uv) {
  double twice = 0;
  for (std::size_t c = 0; c < uv.value.size(); c += 3) {
    const Eigen::Vector2d a = uv.value[c + 1] - uv.value[c], b = uv.value[c + 2] - uv.value[c];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/// The positions as UVs, scaled about the origin to the area that the UVs had.
void WritePositions(const Triangulation& open, const Eigen::VectorXcd& z, CornerUv* uv) {
  const double area = ImageArea(*uv);
  for (Index c = 0; c < open.num_halfedges(); ++c) {
    const std::complex<double> p = z[open.vertex[c]];
    uv->value[c] = {p.real(), p.imag()};
  }
  const double scale = std::sqrt(area / ImageArea(*uv));
  for (Eigen::Vector2d& p : uv->value) p *= scale;
}

}  // namespace

const OptionTable<RefineMapOptions>& RefineMapOptionTable() {
  using O = RefineMapOptions;
  static const OptionTable<O> kTable(
      "refine_map",
      {Option<O>("steps", &O::steps, "the most steps").Between(1, 1e6),
       Option<O>("decrease", &O::decrease, "share of the objective to go on for").Between(0, 1)});
  return kTable;
}

StatusOr<MapRefinement> RefineMap(const SeamedSurface& of, const MapObjective& objective,
                                  const RefineMapOptions& options,
                                  const std::atomic<bool>* cancelled, CornerUv* uv) {
  const Triangulation& t = of.surface.triangulation;
  const Triangulation open = CutOpen(t, of.cut);
  BeltramiSystem system(t, open, of.surface.angles, of.surface.lengths,
                        SeamConstraints(t, open, of.seams), objective);
  Refiner refiner(open, &system, PositionsOf(open, *uv));
  MapRefinement result{0, refiner.value(), refiner.value()};
  while (result.steps < options.steps) {
    if (cancelled && *cancelled)
      return Status(StatusCode::kCancelled, "refinement of the map: interrupted");
    if (!refiner.Step()) break;
    ++result.steps;
    const double decrease = result.after - refiner.value();
    result.after = refiner.value();
    if (decrease <= options.decrease * result.after) break;
  }
  if (result.steps > 0) WritePositions(open, refiner.z(), uv);
  return result;
}

}  // namespace cirque
