#pragma once

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/linear/sparse_cholesky.h"

namespace cirque {

/// Newton's system of an angle fit's dual with extra rows C' (FitWithRows), P the block diagonal
/// derivative d alpha / d s:
///   [ A P A'  A P C' ] [ dy ]     [ by_y ]
///   [ C P A'  C P C' ] [ dz ] = - [ by_z ].
class RowSystem {
 public:
  /// `rows` is C', 3F x m. All must outlive the system; rows may change until Factorize.
  RowSystem(const AngleConstraints& constraints, const Eigen::MatrixXd& rows,
            SparseCholesky* factor);

  /// The factor of A P A' + damping. `conjugates`, one an edge, must live until the next. False:
  /// not positive definite.
  bool Factorize(const std::vector<EdgeConjugate>& conjugates, double damping);

  /// X = (A P A')^-1 A P C', column by column.
  Eigen::MatrixXd Response();

  /// The Schur complement S at the last factor's point. `response`: X, or null where it vanishes.
  Eigen::MatrixXd Schur(const Eigen::MatrixXd* response) const;

  /// Solves the system; S by conjugate gradients preconditioned by `schur`, which becomes that of
  /// this point where it is empty or too far from it.
  void Solve(const Eigen::VectorXd& by_y, const Eigen::VectorXd& by_z,
             Eigen::LDLT<Eigen::MatrixXd>* schur, Eigen::VectorXd* dy, Eigen::VectorXd* dz);

 private:
  Eigen::VectorXd ApplyP(const Eigen::Ref<const Eigen::VectorXd>& x) const;
  Eigen::VectorXd ApplySchur(const Eigen::VectorXd& v);
  bool SolveSchur(const Eigen::LDLT<Eigen::MatrixXd>& preconditioner, const Eigen::VectorXd& b,
                  Eigen::VectorXd* x);

  const AngleConstraints& constraints_;
  const Triangulation& t_;
  const Eigen::MatrixXd& rows_;
  const std::vector<EdgeConjugate>* conjugates_ = nullptr;
  SparseCholesky& factor_;  ///< of A P A'
};

/// A' y: the slope of every corner, 3F.
Eigen::VectorXd SlopesOf(const AngleConstraints& constraints,
                         const Eigen::Ref<const Eigen::VectorXd>& y);

}  // namespace cirque
