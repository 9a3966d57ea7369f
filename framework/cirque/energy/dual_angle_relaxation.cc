#include <cmath>
#include <vector>

#include "cirque/energy/dual_angle_energy.h"
#include "cirque/energy/relax_parameters.h"

namespace cirque {
namespace {

constexpr int kMaxTrials = 4;
constexpr double kEnough = 0.5;  ///< of the excess, at most, may be left with the other sign
constexpr double kLeastCurvature = 1e-6;  ///< below, all of a row's angles are at their bounds

}  // namespace

/// Rows' multipliers, one at a time, on their way to where the row's sum is met: a scalar equation,
/// monotone and mostly linear in pieces.
class DualAngleEnergy::RowMove {
 public:
  RowMove(const DualAngleEnergy& energy, double* y) : energy_(energy), y_(y) {}

  /// Turns to a row.
  void Take(int row) {
    row_ = row;
    start_ = y_[row];
    edges_.clear();
    const Triangulation& t = energy_.constraints_.triangulation();
    energy_.ForEachCornerOfRow(row, [&](Index h) {
      const Index l = t.edge_halfedge[t.edge[h]], r = t.twin[l];
      const bool has_l = energy_.IsInRow(l, row), has_r = r != kNone && energy_.IsInRow(r, row);
      if (h == r && has_l) return;
      edges_.push_back({t.edge[h], has_l, has_r, energy_.Conjugate(t.edge[h], y_), {}});
    });
  }

  /// From where the row's sum is too large by `excess`.
  void Run(double excess) {
    double step = -excess / Curvature();
    for (int trial = 0; trial < kMaxTrials && std::isfinite(step); ++trial) {
      const double left = MoveTo(start_ + step, excess);
      const bool enough = std::abs(left) <= kEnough * std::abs(excess);
      if (left * excess >= 0 || (enough && ValueChange() <= 0)) return;
      step *= excess / (excess - left);
    }
    MoveTo(start_, excess);
  }

  template <class Change>
  void TellChanges(const Change& change) const {
    const Triangulation& t = energy_.constraints_.triangulation();
    const auto tell = [&](Index h, double by) {
      if (by == 0) return;
      change(Triangulation::Face(h), by);
      if (const int row = energy_.constraints_.VertexRow(h); row != kNone) change(row, by);
    };
    for (const RowEdge& edge : edges_) {
      const Index l = t.edge_halfedge[edge.e], r = t.twin[l];
      tell(l, edge.after.alpha_l - edge.before.alpha_l);
      if (r != kNone) tell(r, edge.after.alpha_r - edge.before.alpha_r);
    }
  }

 private:
  struct RowEdge {
    Index e;
    bool has_l, has_r;  ///< which of the edge's angles the row adds up
    EdgeConjugate before, after;
  };

  /// d sum / d y; 0 where hardly any angle can move.
  double Curvature() const {
    double sum = 0;
    for (const RowEdge& e : edges_) {
      if (e.has_l) sum += e.before.h_ll;
      if (e.has_r) sum += e.before.h_rr;
      if (e.has_l && e.has_r) sum += 2 * e.before.h_lr;
    }
    return sum > kLeastCurvature ? sum : 0;
  }

  /// By how much the energy is higher than at the start.
  double ValueChange() const {
    double change = -energy_.constraints_.Lower(row_) * (y_[row_] - start_);
    for (const RowEdge& e : edges_) change += e.after.value - e.before.value;
    return change;
  }

  /// The excess there.
  double MoveTo(double value, double excess) {
    y_[row_] = value;
    for (RowEdge& e : edges_) {
      e.after = energy_.Conjugate(e.e, y_);
      if (e.has_l) excess += e.after.alpha_l - e.before.alpha_l;
      if (e.has_r) excess += e.after.alpha_r - e.before.alpha_r;
    }
    return excess;
  }

  const DualAngleEnergy& energy_;
  double* y_;
  int row_ = 0;
  double start_ = 0;
  std::vector<RowEdge> edges_;
};

bool DualAngleEnergy::Relax(double threshold, double* y, double* gradient) const {
  if (constraints_.HasRanges() || objective_->TakesArrays()) return false;
  Eigen::Map<Eigen::VectorXd> of_row(gradient, NumParameters());
  RowMove move(*this, y);
  return RelaxParameters(threshold, of_row, [&](int row, const auto& change) {
    move.Take(row);
    move.Run(of_row[row]);
    move.TellChanges(change);
  });
}

bool DualAngleEnergy::IsInRow(Index h, int row) const {
  const int rows_of_faces = constraints_.num_faces();
  return row < rows_of_faces ? Triangulation::Face(h) == row : constraints_.VertexRow(h) == row;
}

}  // namespace cirque
