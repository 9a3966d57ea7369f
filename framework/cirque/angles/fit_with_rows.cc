#include "cirque/angles/fit_with_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "cirque/core/parallel.h"
#include "cirque/energy/edge_block_assembler.h"
#include "cirque/linear/registry.h"
#include "cirque/linear/sparse_cholesky.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {
namespace {

constexpr int kMostIterations = 40, kMostHalvings = 30;
constexpr double kTolerance = 1e-13;  ///< [rad] of every sum
constexpr double kRounding = 1e-11;   ///< [rad]: errors below that a whole step lowers, or nothing
constexpr double kAccepted = 1e-10;   ///< [rad], where rounding ends the steps
constexpr double kArmijo = 1e-4;
/// Damping: on the diagonal of A P A', which is singular where P makes a row vanish.
constexpr double kLeastDamping = 1e-9, kRaisedDamping = 1e-5, kShortStep = 1e-2;

/// The dual at a point.
struct DualPoint {
  Eigen::VectorXd y, z;
  std::vector<EdgeConjugate> conjugate;  ///< per edge
  double value = 0;
  Eigen::VectorXd by_y, by_z;

  double LargestError() const {
    return std::max(by_y.lpNorm<Eigen::Infinity>(), by_z.lpNorm<Eigen::Infinity>());
  }
};

class RowFit {
 public:
  RowFit(const AngleFitProblem& problem, const AngleObjective& objective, const ExtraRows& extra)
      : problem_(problem),
        constraints_(problem.constraints),
        t_(constraints_.triangulation()),
        objective_(objective),
        rows_(extra.rows),
        from_(extra.from),
        change_(extra.change),
        sums_(constraints_.num_rows()),
        edges_(t_.num_edges()),
        cholesky_(MakeCholesky()) {
    for (int row = 0; row < constraints_.num_rows(); ++row) sums_[row] = constraints_.Lower(row);
  }

  /// True where the sums are met to kAccepted.
  bool Run(const SolveControl& control, Eigen::VectorXd y, Eigen::VectorXd z) {
    at_.y = std::move(y);
    at_.z = std::move(z);
    Evaluate(&at_);
    if (!Linearize() || !ProjectRows()) return false;
    for (; iterations_ < kMostIterations && at_.LargestError() > kTolerance; ++iterations_) {
      if (control.cancelled && *control.cancelled) break;
      if (iterations_ > 0 && !Linearize()) break;
      if (!Step()) break;
    }
    return at_.LargestError() <= kAccepted;
  }

  const DualPoint& at() const { return at_; }
  int iterations() const { return iterations_; }

  /// y where the multipliers of the rows as they were given are z.
  Eigen::VectorXd Multipliers() const { return at_.y - projection_ * at_.z; }

  Eigen::VectorXd Angles(const DualPoint& at) const {
    Eigen::VectorXd alpha(t_.num_halfedges());
    for (Index e = 0; e < t_.num_edges(); ++e) {
      const Index h = t_.edge_halfedge[e];
      alpha[h] = at.conjugate[e].alpha_l;
      if (t_.twin[h] != kNone) alpha[t_.twin[h]] = at.conjugate[e].alpha_r;
    }
    return alpha;
  }

 private:
  void Evaluate(DualPoint* at) {
    const Eigen::VectorXd of_rows = rows_ * at->z;
    const auto slope = [&](Index h) { return constraints_.Slope(at->y.data(), h) + of_rows[h]; };
    ParallelFor(t_.num_edges(), [&](Index e) {
      const Index h = t_.edge_halfedge[e], g = t_.twin[h];
      const Eigen::VectorXd& reference = problem_.reference;
      edges_[e] = g == kNone ? EdgeSlopes{reference[h], 0, slope(h), 0, true}
                             : EdgeSlopes{reference[h], reference[g], slope(h), slope(g), false};
    });
    at->conjugate.resize(edges_.size());
    objective_.Conjugates(edges_, problem_.epsilon, at->conjugate);
    at->value = -sums_.dot(at->y) - (rows_.transpose() * from_ + change_).dot(at->z);
    for (const EdgeConjugate& c : at->conjugate) at->value += c.value;
    const Eigen::VectorXd alpha = Angles(*at);
    at->by_y = constraints_.Apply(alpha) - sums_;
    at->by_z = rows_.transpose() * (alpha - from_) - change_;
  }

  /// P x.
  Eigen::VectorXd ApplyP(const Eigen::Ref<const Eigen::VectorXd>& x) const {
    Eigen::VectorXd moved(t_.num_halfedges());
    for (Index e = 0; e < t_.num_edges(); ++e) {
      const Index h = t_.edge_halfedge[e], g = t_.twin[h];
      const EdgeConjugate& c = at_.conjugate[e];
      moved[h] = c.h_ll * x[h];
      if (g == kNone) continue;
      moved[h] += c.h_lr * x[g];
      moved[g] = c.h_lr * x[h] + c.h_rr * x[g];
    }
    return moved;
  }

  /// The factor of A P A', X = (A P A')^-1 A P C' and the Schur complement.
  bool Linearize() {
    EdgeBlockAssembler matrix(constraints_);
    for (Index e = 0; e < t_.num_edges(); ++e) {
      const Index h = t_.edge_halfedge[e], g = t_.twin[h];
      const EdgeConjugate& c = at_.conjugate[e];
      matrix.Add(h, h, c.h_ll);
      if (g == kNone) continue;
      matrix.Add(g, g, c.h_rr);
      matrix.Add(h, g, c.h_lr);
      matrix.Add(g, h, c.h_lr);
    }
    for (int row = 0; row < constraints_.num_rows(); ++row) matrix.AddToDiagonal(row, damping_);
    if (constraints_.HasGauge()) matrix.AddToDiagonal(constraints_.num_faces(), 1);
    SparseMatrix lower;
    matrix.Assemble(&lower);
    if (!cholesky_->Factorize(lower)) return false;
    FormSchurComplement();
    return true;
  }

  void FormSchurComplement() {
    const auto m = static_cast<int>(rows_.cols());
    response_.resize(constraints_.num_rows(), m);
    Eigen::MatrixXd moved(rows_.rows(), m);
    for (int q = 0; q < m; ++q) {
      moved.col(q) = ApplyP(rows_.col(q));
      response_.col(q) = cholesky_->Solve(constraints_.Apply(moved.col(q)));
    }
    // C P (C' - A' X), without the large parts that cancel.
    schur_ = moved.transpose() * (rows_ - ApplyTransposedA(response_));
    schur_.diagonal().array() += kLeastDamping * kLeastDamping;
  }

  /// A' Y, column by column.
  Eigen::MatrixXd ApplyTransposedA(const Eigen::MatrixXd& y) const {
    Eigen::MatrixXd slopes(t_.num_halfedges(), y.cols());
    for (int q = 0; q < y.cols(); ++q) {
      for (Index h = 0; h < t_.num_halfedges(); ++h) {
        slopes(h, q) = constraints_.Slope(y.col(q).data(), h);
      }
    }
    return slopes;
  }

  /// Takes from the rows what rows of A say already; the multipliers of A take over what z was.
  bool ProjectRows() {
    projection_ = response_;
    rows_ -= ApplyTransposedA(projection_);
    change_ -= projection_.transpose() * (sums_ - constraints_.Apply(from_));
    at_.y += projection_ * at_.z;
    Evaluate(&at_);
    return Linearize();
  }

  bool Step() {
    const Eigen::VectorXd dz = schur_.ldlt().solve(response_.transpose() * at_.by_y - at_.by_z);
    const Eigen::VectorXd dy = -cholesky_->Solve(at_.by_y) - response_ * dz;
    const double slope = at_.by_y.dot(dy) + at_.by_z.dot(dz);
    if (!std::isfinite(slope)) return false;
    double length = 1;
    const int most = at_.LargestError() > kRounding ? kMostHalvings : 1;
    for (int i = 0; i < most; ++i, length /= 2) {
      DualPoint next;
      next.y = at_.y + length * dy;
      next.z = at_.z + length * dz;
      Evaluate(&next);
      // Near the solution values differ by rounding only, errors still tell.
      const bool lower = next.value <= at_.value + kArmijo * length * slope;
      if (!lower && !(next.LargestError() < at_.LargestError())) continue;
      at_ = std::move(next);
      damping_ = length < kShortStep ? std::max(kRaisedDamping, 100 * damping_) : kLeastDamping;
      return true;
    }
    return false;
  }

  const AngleFitProblem& problem_;
  const AngleConstraints& constraints_;
  const Triangulation& t_;
  const AngleObjective& objective_;
  Eigen::MatrixXd rows_, projection_, response_, schur_;
  const Eigen::VectorXd& from_;
  Eigen::VectorXd change_, sums_;
  std::vector<EdgeSlopes> edges_;
  std::unique_ptr<SparseCholesky> cholesky_;
  DualPoint at_;
  double damping_ = kLeastDamping;
  int iterations_ = 0;
};

}  // namespace

Status FitWithRows(const AngleFitProblem& problem,
                   const std::shared_ptr<const AngleObjective>& objective, const ExtraRows& extra,
                   const SolveControl& control, Eigen::VectorXd* z, AngleFitResult* result) {
  const AngleConstraints& constraints = problem.constraints;
  if (constraints.HasRanges()) {
    return Status::InvalidInput("an angle fit with extra rows takes no ranged angle sums");
  }
  RowFit fit(problem, *objective, extra);
  if (z->size() != extra.change.size()) z->setZero(extra.change.size());
  const bool met = fit.Run(
      control, problem.start ? *problem.start : Eigen::VectorXd::Zero(constraints.num_rows()), *z);
  if (control.cancelled && *control.cancelled) {
    return Status(StatusCode::kCancelled, "angle fit: cancelled");
  }
  if (!met) {
    return Status(
        StatusCode::kNotConverged,
        fmt::format("angle fit with {} extra rows: sums miss by {:.1e} rad after {} steps",
                    extra.change.size(), fit.at().LargestError(), fit.iterations()));
  }
  *z = fit.at().z;
  result->multipliers = fit.Multipliers();
  result->angles = {fit.Angles(fit.at()), problem.epsilon};
  result->kkt = CheckFeasibility(constraints, result->angles.value);
  CloseTriangles(&result->angles.value);
  return Status();
}

}  // namespace cirque
