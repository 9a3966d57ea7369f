#include "cirque/angles/row_system.h"

#include <algorithm>

#include "cirque/core/parallel.h"
#include "cirque/energy/edge_block_assembler.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {
namespace {

constexpr int kColumns = 32;         ///< of S, that one task forms
constexpr int kSolvesPerStep = 8;    ///< m over it: how many gradient steps cost less than a new S
constexpr double kTolerance = 1e-8;  ///< of S dz, relative: Newton's steps correct the rest
constexpr double kLeastDiagonal = 1e-18;  ///< on S's, lest rows that say the same divide by 0

}  // namespace

Eigen::VectorXd SlopesOf(const AngleConstraints& constraints,
                         const Eigen::Ref<const Eigen::VectorXd>& y) {
  Eigen::VectorXd slopes(constraints.triangulation().num_halfedges());
  for (Index h = 0; h < slopes.size(); ++h) slopes[h] = constraints.Slope(y.data(), h);
  return slopes;
}

RowSystem::RowSystem(const AngleConstraints& constraints, const Eigen::MatrixXd& rows,
                     SparseCholesky* factor)
    : constraints_(constraints), t_(constraints.triangulation()), rows_(rows), factor_(*factor) {}

bool RowSystem::Factorize(const std::vector<EdgeConjugate>& conjugates, double damping) {
  conjugates_ = &conjugates;
  EdgeBlockAssembler matrix(constraints_);
  for (Index e = 0; e < t_.num_edges(); ++e) {
    const Index h = t_.edge_halfedge[e], g = t_.twin[h];
    const EdgeConjugate& c = conjugates[e];
    matrix.Add(h, h, c.h_ll);
    if (g == kNone) continue;
    matrix.Add(g, g, c.h_rr);
    matrix.Add(h, g, c.h_lr);
    matrix.Add(g, h, c.h_lr);
  }
  for (int row = 0; row < constraints_.num_rows(); ++row) matrix.AddToDiagonal(row, damping);
  if (constraints_.HasGauge()) matrix.AddToDiagonal(constraints_.num_faces(), 1);
  SparseMatrix lower;
  matrix.Assemble(&lower);
  return factor_.Factorize(lower);
}

/// P x.
Eigen::VectorXd RowSystem::ApplyP(const Eigen::Ref<const Eigen::VectorXd>& x) const {
  Eigen::VectorXd moved(t_.num_halfedges());
  for (Index e = 0; e < t_.num_edges(); ++e) {
    const Index h = t_.edge_halfedge[e], g = t_.twin[h];
    const EdgeConjugate& c = (*conjugates_)[e];
    moved[h] = c.h_ll * x[h];
    if (g == kNone) continue;
    moved[h] += c.h_lr * x[g];
    moved[g] = c.h_lr * x[h] + c.h_rr * x[g];
  }
  return moved;
}

Eigen::MatrixXd RowSystem::Response() {
  Eigen::MatrixXd response(constraints_.num_rows(), rows_.cols());
  for (int q = 0; q < rows_.cols(); ++q) {
    response.col(q) = factor_.Solve(constraints_.Apply(ApplyP(rows_.col(q))));
  }
  return response;
}

/// C P (C' - A' X), without the large parts that cancel; by symmetry the lower triangle alone.
Eigen::MatrixXd RowSystem::Schur(const Eigen::MatrixXd* response) const {
  const auto m = static_cast<int>(rows_.cols());
  Eigen::MatrixXd schur = Eigen::MatrixXd::Zero(m, m);
  ParallelTasks((m + kColumns - 1) / kColumns, [&](int task) {
    const int begin = task * kColumns, width = std::min(kColumns, m - begin);
    Eigen::MatrixXd moved(rows_.rows(), width);
    for (int q = 0; q < width; ++q) {
      Eigen::VectorXd left = rows_.col(begin + q);
      if (response) left -= SlopesOf(constraints_, response->col(begin + q));
      moved.col(q) = ApplyP(left);
    }
    schur.block(begin, begin, m - begin, width).noalias() =
        rows_.rightCols(m - begin).transpose() * moved;
  });
  schur.diagonal().array() += kLeastDiagonal;
  return schur;
}

Eigen::VectorXd RowSystem::ApplySchur(const Eigen::VectorXd& v) {
  Eigen::VectorXd left = rows_ * v;
  left -= SlopesOf(constraints_, factor_.Solve(constraints_.Apply(ApplyP(left))));
  return rows_.transpose() * ApplyP(left) + kLeastDiagonal * v;
}

/// Preconditioned conjugate gradients. False where they are not done in time.
bool RowSystem::SolveSchur(const Eigen::LDLT<Eigen::MatrixXd>& preconditioner,
                           const Eigen::VectorXd& b, Eigen::VectorXd* x) {
  const double goal = kTolerance * b.norm();
  Eigen::VectorXd rest = b;
  Eigen::VectorXd direction = preconditioner.solve(rest);
  double slope = rest.dot(direction);
  x->setZero(b.size());
  const auto most = static_cast<int>(b.size()) / kSolvesPerStep;
  for (int i = 0; i < most; ++i) {
    if (rest.norm() <= goal) return true;
    const Eigen::VectorXd image = ApplySchur(direction);
    const double curvature = direction.dot(image);
    if (!(curvature > 0 && slope > 0)) return false;
    *x += slope / curvature * direction;
    rest -= slope / curvature * image;
    const Eigen::VectorXd next = preconditioner.solve(rest);
    const double before = slope;
    slope = rest.dot(next);
    direction = next + slope / before * direction;
  }
  return rest.norm() <= goal;
}

void RowSystem::Solve(const Eigen::VectorXd& by_y, const Eigen::VectorXd& by_z,
                      Eigen::LDLT<Eigen::MatrixXd>* schur, Eigen::VectorXd* dy,
                      Eigen::VectorXd* dz) {
  const Eigen::VectorXd without_rows = factor_.Solve(by_y);
  const Eigen::VectorXd right =
      rows_.transpose() * ApplyP(SlopesOf(constraints_, without_rows)) - by_z;
  if (schur->rows() != rows_.cols() || !SolveSchur(*schur, right, dz)) {
    const Eigen::MatrixXd response = Response();
    schur->compute(Schur(&response));
    *dz = schur->solve(right);
  }
  *dy = -without_rows - factor_.Solve(constraints_.Apply(ApplyP(rows_ * *dz)));
}

}  // namespace cirque
