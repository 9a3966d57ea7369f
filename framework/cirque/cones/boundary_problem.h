#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/cone_file.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {

class SparseCholesky;

/// A surface whose boundary may turn as it likes, with the linear model of what that does to it: the
/// metric e^{2u} g has the curvatures K + L u, L the cotangent Laplacian, K_v = 2 pi - Theta_v inside
/// and pi - Theta_v on the boundary. Inside the curvature is prescribed (0, or that of a cone), so
/// that u is known from its values b on the boundary: u = u_0 + H b, u_0 with 0 on the boundary, H
/// the harmonic extension. The boundary then turns by K + L u (R. Sawhney, K. Crane, "Boundary First
/// Flattening", 2017, sec. 4).
///
/// Boundary vertices whose angle sums would be beyond their bounds get these prescribed and count as
/// inside ("settled") from then on; the others are "open".
class BoundaryProblem {
 public:
  /// Angle sums that a boundary vertex may have [rad].
  struct Bounds {
    double lower, upper;
  };

  /// `targets` of the inner vertices (ranged ones in the middle of their interval); those of the
  /// boundary do not matter. The surface should be of intrinsic Delaunay connectivity; `input` is
  /// the same surface as its user has it, whose corners bound the angle sums as well; `file`: how a
  /// cone file numbers the vertices (empty: in order). All that is referred to must outlive the problem. @pre the surface has a boundary.
  BoundaryProblem(IntrinsicSurface surface, const IntrinsicSurface& input,
                  const ConeTargets& targets, FileVertices file = {});
  BoundaryProblem(const BoundaryProblem&) = delete;
  BoundaryProblem& operator=(const BoundaryProblem&) = delete;
  ~BoundaryProblem();

  const IntrinsicSurface& surface() const { return surface_; }
  const IntrinsicSurface& input() const { return input_; }
  const FileVertices& file() const { return file_; }
  const Eigen::VectorXd& area() const { return area_; }             ///< V, total 1
  const std::vector<Index>& boundary() const { return boundary_; }  ///< in increasing order
  bool IsOpen(Index v) const { return is_open_[v]; }

  /// What the boundary's angle sums must add up to by Gauss-Bonnet [rad]: pi F less the inner ones.
  double TotalAngleSum() const { return total_; }

  /// From a fifth of pi (or .8 of what there is, where that is less) to 1.75 pi or .8 pi a corner.
  Bounds BoundsOf(Index v) const;

  /// u_0 + H b, V; b counts at the open vertices.
  Eigen::VectorXd LogScale(const Eigen::VectorXd& b) const;
  /// H b, V.
  Eigen::VectorXd Harmonic(const Eigen::VectorXd& b) const;
  /// H' w: V, 0 but at the open vertices.
  Eigen::VectorXd HarmonicAdjoint(const Eigen::VectorXd& w) const;

  /// Angle sums of the boundary in e^{2u} g [rad], V, 0 inside.
  Eigen::VectorXd AngleSums(const Eigen::VectorXd& u) const;

  /// Settles the open vertices whose angle sums are beyond their bounds, at these; whether there
  /// were any. One vertex stays open in any case.
  bool SettleBeyondBounds(const Eigen::VectorXd& angle_sums);

  /// The angle sums within the bounds that are nearest to the given ones (by one shift) and add up to
  /// TotalAngleSum to the last digits. Error (invalid input): the bounds leave none.
  StatusOr<Eigen::VectorXd> FitToGaussBonnet(const Eigen::VectorXd& angle_sums) const;

 private:
  void Number();
  double Missing(const Eigen::VectorXd& angle_sums) const;
  SparseCholesky& Factor() const;
  Eigen::VectorXd SolveInside(const Eigen::VectorXd& right_side) const;

  IntrinsicSurface surface_;
  const IntrinsicSurface& input_;
  FileVertices file_;
  std::vector<Index> boundary_;
  std::vector<bool> is_open_;
  std::vector<Index> inside_, number_;  ///< unknowns of the factor, and their numbers
  SparseMatrix laplacian_;              ///< V x V, whole
  Eigen::VectorXd curvature_;           ///< K, V [rad]
  Eigen::VectorXd prescribed_;          ///< V [rad]: counts where u is unknown
  Eigen::VectorXd area_;
  double total_ = 0;
  mutable std::unique_ptr<SparseCholesky> factor_;
};

}  // namespace cirque
