#include "cirque/angles/fit_with_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/angles/row_system.h"
#include "cirque/core/parallel.h"
#include "cirque/linear/registry.h"

namespace cirque {
namespace {

constexpr int kMostIterations = 40, kMostHalvings = 30;
/// Steps that do not halve the error: where there are no such angles multipliers grow instead.
constexpr int kMostIdle = 10;
constexpr double kTolerance = 1e-13;  ///< [rad] of every sum
constexpr double kRounding = 1e-11;   ///< [rad]: errors below that a whole step lowers, or nothing
constexpr double kNear = 1e-5;        ///< [rad]: errors below which they are what is lowered
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
  RowFit(const AngleFitProblem& problem, const AngleObjective& objective, const ExtraRows& extra,
         RowFitMemory* memory)
      : problem_(problem),
        constraints_(problem.constraints),
        t_(constraints_.triangulation()),
        objective_(objective),
        from_(extra.from),
        memory_(*memory),
        rows_(extra.rows),
        change_(extra.change),
        sums_(constraints_.num_rows()),
        edges_(t_.num_edges()),
        system_(constraints_, rows_, memory->factor.get()) {
    for (int row = 0; row < constraints_.num_rows(); ++row) sums_[row] = constraints_.Lower(row);
  }

  /// True where the sums are met to kAccepted.
  bool Run(const SolveControl& control, Eigen::VectorXd y, Eigen::VectorXd z) {
    at_.y = std::move(y);
    at_.z = std::move(z);
    if (!ProjectRows()) return false;
    Evaluate(&at_);
    double least = at_.LargestError();
    int idle = 0;  // steps since the error was halved
    for (; iterations_ < kMostIterations && at_.LargestError() > kTolerance; ++iterations_) {
      if (control.cancelled && *control.cancelled) break;
      idle = at_.LargestError() < 0.5 * least || iterations_ == 0 ? 0 : idle + 1;
      least = std::min(least, at_.LargestError());
      if (idle == kMostIdle) break;
      if (!system_.Factorize(at_.conjugate, damping_) || !Step()) break;
    }
    return at_.LargestError() <= kAccepted;
  }

  const DualPoint& at() const { return at_; }
  int iterations() const { return iterations_; }

  /// y where the multipliers of the rows as they were given are z.
  Eigen::VectorXd Multipliers() const { return at_.y - memory_.projection * at_.z; }

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
    at->value = -sums_.dot(at->y) - (rows_from_ + change_).dot(at->z);
    for (const EdgeConjugate& c : at->conjugate) at->value += c.value;
    const Eigen::VectorXd alpha = Angles(*at);
    at->by_y = constraints_.Apply(alpha) - sums_;
    at->by_z = rows_.transpose() * (alpha - from_) - change_;
  }

  /// Takes from the rows what rows of A say already; the multipliers of A take over what z was.
  /// What is taken may be that of rows that differ a little: it is exact whatever is taken.
  bool ProjectRows() {
    Eigen::MatrixXd& projection = memory_.projection;
    const bool known = projection.rows() == sums_.size() && projection.cols() == rows_.cols();
    if (!known && !FindProjection()) return false;
    ParallelTasks(static_cast<int>(rows_.cols()),
                  [&](int q) { rows_.col(q) -= SlopesOf(constraints_, projection.col(q)); });
    rows_from_ = rows_.transpose() * from_;
    change_ -= projection.transpose() * (sums_ - constraints_.Apply(from_));
    at_.y += projection * at_.z;
    if (!known) memory_.schur.compute(system_.Schur(nullptr));
    return true;
  }

  bool FindProjection() {
    rows_from_ = rows_.transpose() * from_;
    Evaluate(&at_);
    if (!system_.Factorize(at_.conjugate, damping_)) return false;
    memory_.projection = system_.Response();
    return true;
  }

  bool Step() {
    Eigen::VectorXd dy, dz;
    system_.Solve(at_.by_y, at_.by_z, &memory_.schur, &dy, &dz);
    const double slope = at_.by_y.dot(dy) + at_.by_z.dot(dz);
    if (!std::isfinite(slope)) return false;
    double length = 1;
    const int most = at_.LargestError() > kRounding ? kMostHalvings : 1;
    for (int i = 0; i < most; ++i, length /= 2) {
      DualPoint next;
      next.y = at_.y + length * dy;
      next.z = at_.z + length * dz;
      Evaluate(&next);
      const bool lower = next.value <= at_.value + kArmijo * length * slope;
      // Near the solution values differ by rounding only, errors still tell. Farther off an error
      // may fall on the way up, where Newton's steps lead nowhere.
      const bool nearer = next.LargestError() < at_.LargestError();
      if (!lower && !(nearer && at_.LargestError() < kNear)) continue;
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
  const Eigen::VectorXd& from_;
  RowFitMemory& memory_;
  Eigen::MatrixXd rows_;
  Eigen::VectorXd change_, sums_, rows_from_;
  std::vector<EdgeSlopes> edges_;
  RowSystem system_;
  DualPoint at_;
  double damping_ = kLeastDamping;
  int iterations_ = 0;
};

}  // namespace

Status FitWithRows(const AngleFitProblem& problem,
                   const std::shared_ptr<const AngleObjective>& objective, const ExtraRows& extra,
                   const SolveControl& control, RowFitMemory* memory, AngleFitResult* result) {
  const AngleConstraints& constraints = problem.constraints;
  if (constraints.HasRanges()) {
    return Status::InvalidInput("an angle fit with extra rows takes no ranged angle sums");
  }
  if (!memory->factor) memory->factor = MakeCholesky();
  RowFit fit(problem, *objective, extra, memory);
  if (memory->z.size() != extra.change.size()) memory->z.setZero(extra.change.size());
  const bool met = fit.Run(
      control, problem.start ? *problem.start : Eigen::VectorXd::Zero(constraints.num_rows()),
      memory->z);
  if (control.cancelled && *control.cancelled) {
    return Status(StatusCode::kCancelled, "angle fit: cancelled");
  }
  if (!met) {
    return Status(
        StatusCode::kNotConverged,
        fmt::format("angle fit with {} extra rows: sums miss by {:.1e} rad after {} steps",
                    extra.change.size(), fit.at().LargestError(), fit.iterations()));
  }
  memory->z = fit.at().z;
  result->multipliers = fit.Multipliers();
  result->angles = {fit.Angles(fit.at()), problem.epsilon};
  result->kkt = CheckFeasibility(constraints, result->angles.value);
  CloseTriangles(&result->angles.value);
  return Status();
}

}  // namespace cirque
