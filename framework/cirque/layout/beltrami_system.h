#pragma once

#include <array>
#include <complex>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/layout/map_objective.h"
#include "cirque/layout/seams.h"
#include "cirque/linear/hermitian_cholesky.h"

namespace cirque {

/// That the two sides of every edge on a seam differ by the seam's rotation: of four vertices of
/// the opened surface, (z_0 - z_1) - e^{i rotation} (z_2 - z_3) = 0.
struct SeamConstraint {
  std::array<Index, 4> vertex;  ///< right tip, right tail, left tip, left tail
  std::array<std::complex<double>, 4> factor;
  Index left_face, right_face;

  /// The left side of the equation at z.
  std::complex<double> operator()(const Eigen::VectorXcd& z) const;
};

/// One for every edge of the seams. `open`: the surface cut open, of the same halfedges.
std::vector<SeamConstraint> SeamConstraints(const Triangulation& triangulation,
                                            const Triangulation& open,
                                            const std::vector<Seam>& seams);

/// The mean of an objective over the faces of a map z (a complex number per vertex) of a surface,
/// weighted by their areas, and the Hermitian matrices of its Gauss-Newton steps. Faces without
/// area on the surface are left out.
class BeltramiSystem {
 public:
  /// `angles` and `lengths` are of `surface` before it was opened to `open`, which must outlive the
  /// system.
  BeltramiSystem(const Triangulation& surface, const Triangulation& open,
                 const CornerAngles& angles, const EdgeLengths& lengths,
                 std::vector<SeamConstraint> constraints, MapObjective objective);

  /// The objective, infinite where some |mu| >= 1.
  double Value(const Eigen::VectorXcd& z) const;

  /// The linear model at z: gradient = sum A w conj(J) mu, N, and the lower triangle of
  /// sum A w J* J + C* P C, with C the seam constraints and P = diag(penalty), which outweighs the
  /// faces at each seam. @pre Value(z) is finite.
  void Linearize(const Eigen::VectorXcd& z);

  const std::vector<SeamConstraint>& constraints() const { return constraints_; }
  const Eigen::VectorXcd& gradient() const { return gradient_; }
  const Eigen::VectorXd& penalty() const { return penalty_; }
  const ComplexSparseMatrix& lower() const { return lower_; }

 private:
  using Complex = std::complex<double>;
  /// What a face's vertices contribute to sum z_i G_i = 2 A f_zbar: G_i is the gradient of vertex
  /// i's hat function, times twice the area, of a triangle similar to the face.
  struct Face {
    Index index;
    double area;  ///< all sum to 1
    std::array<Complex, 3> hat;
  };
  struct Beltrami {
    Complex mu, f_z;
  };

  Beltrami Measure(const Face& face, const Eigen::VectorXcd& z) const;
  void LayOutPattern();
  void AddToLower(Index i, Index j, Complex value);
  void AddPenalties(const std::vector<double>& stiffness);
  void ShiftDiagonal();

  const Triangulation& open_;
  const std::vector<SeamConstraint> constraints_;
  const MapObjective objective_;
  std::vector<Face> faces_;
  ComplexSparseMatrix lower_;
  Eigen::VectorXcd gradient_;
  Eigen::VectorXd penalty_;
};

}  // namespace cirque
