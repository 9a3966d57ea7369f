#pragma once

#include <memory>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/energy/energy.h"
#include "cirque/energy/energy_source.h"

namespace cirque {

/// The Lagrange dual of an angle fit, a convex function without constraints of the multipliers y of
/// A alpha = b:
///   f(y) = sum_e g_e((A'y)_e) - b.y,      grad f = A alpha(y) - b,      Hess f = A diag(d alpha /
///   d s) A'
/// with g_e the objective's conjugate over Q_e. min f = -min of the primal objective; where the
/// constraints are infeasible f is unbounded below along a Farkas certificate. The sum of a ranged
/// vertex lies in an interval instead of at b_v: its multiplier pays b_v = lower where it is
/// positive and b_v = upper where it is not, a kink at 0.
class DualAngleEnergy final : public Energy, private EnergySource {
 public:
  /// `reference` (3F angles [rad]) and the constraints' triangulation must outlive the energy.
  DualAngleEnergy(AngleConstraints constraints, const Eigen::VectorXd& reference, double epsilon,
                  std::shared_ptr<const AngleObjective> objective);

  int NumParameters() const override { return constraints_.num_rows(); }
  bool Evaluate(const double* y, double* value, double* gradient) const override;
  bool Hessian(const double* y, SparseMatrix* lower) const override;

  /// As if no inequality were active: whatever y is.
  bool SmoothHessian(const double* y, SparseMatrix* lower) const override;
  std::vector<int> GaugeParameters() const override;
  std::vector<Kink> Kinks() const override;
  double LeastDamping() const override { return 1e-9; }

  /// One row's multiplier at a time (dual_angle_relaxation.cc). Not with ranged vertices.
  bool Relax(double threshold, double* y, double* gradient) const override;

  bool Share(const double* y, const std::vector<bool>& own, double* share) const override;

  /// Of fixed angle sums and the table's objectives that take one edge after another.
  const EnergySource* source() const override;

  /// alpha(y): the maximisers of all edges, 3F [rad].
  Eigen::VectorXd Angles(const double* y) const;

  /// The energy too.
  Eigen::VectorXd Angles(const double* y, double* value) const;

  /// The distances of corner angles from their references, 3F.
  std::vector<ScalarJet> Distances(const Eigen::VectorXd& alpha) const;

  /// The primal objective sum_e phi_e(alpha), of angles or of angles and their Distances().
  double Primal(const Eigen::VectorXd& alpha) const { return Primal(alpha, Distances(alpha)); }
  double Primal(const Eigen::VectorXd& alpha, const std::vector<ScalarJet>& distances) const;

 private:
  EdgeSlopes SlopesAt(Index e, const double* y) const;
  EdgeConjugate Conjugate(Index e, const double* y) const;

  /// Calls visit(e, conjugate) for every edge, in parallel, and adds up what it returns.
  template <class Visit>
  double SumConjugates(const double* y, const Visit& visit) const;

  const char* Work() const override { return kDualAngleWork; }
  const Triangulation& triangulation() const override { return constraints_.triangulation(); }
  std::vector<int> VertexParameters() const override;
  EnergyData DataOf(const MeshPart& part) const override;

  /// The slope of -b.y, where y is; at a kink from below. Fixed targets have both sides equal.
  double Target(const double* y, int row) const {
    return y[row] > 0 ? constraints_.Lower(row) : constraints_.Upper(row);
  }

  /// Whether that row adds up the angle at corner h.
  bool IsInRow(Index h, int row) const;

  template <class Visit>
  void ForEachCornerOfRow(int row, const Visit& visit) const {
    if (row < constraints_.num_faces()) {
      for (Index h = 3 * row; h < 3 * row + 3; ++h) visit(h);
    } else {
      constraints_.triangulation().ForEachCornerAround(
          corner_of_row_[row - constraints_.num_faces()], visit);
    }
  }

  /// Of every corner as the objective takes it.
  std::vector<double> ClampedReferences() const;

  /// alpha(y) and sum_e g_e.
  Eigen::VectorXd Maximise(const double* y, double* sum) const;

  class RowMove;

  const AngleConstraints constraints_;
  const Eigen::VectorXd& reference_;
  const double epsilon_;
  const std::shared_ptr<const AngleObjective> objective_;
  std::vector<Index> corner_of_row_;  ///< one of each constrained vertex
};

}  // namespace cirque
