#pragma once

#include <complex>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/lattice/flat_domain.h"
#include "cirque/layout/seams.h"
#include "cirque/linear/hermitian_cholesky.h"

namespace cirque {

/// A flat domain opened to a disk, with what displacements across its seams obey.
class OpenedDomain {
 public:
  using Complex = std::complex<double>;

  /// For rotations by multiples of 2 pi / order. @pre the domain is closed, and outlives this.
  OpenedDomain(const FlatDomain& domain, int order)
      : domain_(domain), t_(domain.triangulation()), order_(order) {}

  /// Cuts it to a disk, along the given cut or, without one, a short one, and lays that out with cells of
  /// this size. Error (invalid input): rotations along loops that are no multiples (1e-6 rad).
  Status Open(double cell, const Cut* given = nullptr);

  /// Makes faces stiffer, each by its factor.
  Status Stiffen(const Eigen::VectorXd& factors);

  /// How far a displacement is from a translation on every face, the sum of the moduli of its complex
  /// derivatives: below 1 the face is not flipped.
  Eigen::VectorXd Strain(Complex turn, const Eigen::VectorXcd& shift) const;

  Index num_sides() const { return static_cast<Index>(seams_.size()); }
  const Complex& Turn(Index side) const { return turn_[side]; }

  /// The side of the cut graph as it lies in the plane.
  Complex Side(Index p) const;

  /// How the sides change with the places of nodes that are no cones (nor the first, where there are
  /// no cones), a column each; `reached` gets, for each of these nodes, the side by which a tree from
  /// the cones comes to it.
  Eigen::MatrixXcd FreeNodes(std::vector<bool>* reached) const;

  /// The displacement of least energy of all copies of vertices whose sides are displaced by these,
  /// which close.
  Eigen::VectorXcd Displace(const Eigen::VectorXcd& sides) const;

  /// The Hermitian product whose square is the Dirichlet energy: L b, of which it is a' L b.
  Eigen::VectorXcd Laplacian(const Eigen::VectorXcd& b) const;

  /// The layout turned, with a node at 0, and displaced.
  CornerUv Displaced(Complex turn, const Eigen::VectorXcd& shift) const;

 private:
  /// A run of halfedges of the disk's boundary: a side of the cut graph, forwards on its left,
  /// backwards on its right.
  struct Run {
    Index side;
    bool is_left;
    Index from, to;  ///< copies of vertices
  };

  /// Calls visit(tail, tip, weight), copies of vertices, for every halfedge: E = sum of weight
  /// |difference|^2.
  template <class Visit>
  void ForEachSide(const Visit& visit) const {
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      const Eigen::Vector2d a = domain_.Corner(Triangulation::Next(h)) - domain_.Corner(h);
      const Eigen::Vector2d b = domain_.Corner(Triangulation::Prev(h)) - domain_.Corner(h);
      const double cotangent = a.dot(b) / (a.x() * b.y() - a.y() * b.x());
      visit(open_.Tail(h), open_.Tip(h), stiffness_[h / 3] * cotangent / 2);
    }
  }

  /// The nodes that are not there yet, in the order in which sides come to them.
  std::vector<Index> ReachNodes(std::vector<bool> is_there, std::vector<bool>* reached) const;

  /// By how much the frame at a copy of a node is turned against that at its first one. (About cones
  /// they do not agree, and are not asked for.)
  std::vector<Complex> TurnsOfCopies() const;

  void WalkRound();
  void SetNodes(const Eigen::VectorXcd& sides, Eigen::VectorXcd* given) const;
  /// Of the copies on the right of seams, which are where their left ones are taken.
  void SetTranslations(Eigen::VectorXcd* given) const;

  void NumberUnknowns();
  Status Factorize();
  ComplexSparseMatrix Matrix() const;

  const FlatDomain& domain_;
  const Triangulation& t_;
  int order_;
  Triangulation open_;
  CornerUv uv_;  ///< in cells
  std::vector<Seam> seams_;
  std::vector<Complex> turn_;  ///< of every seam
  std::vector<Run> runs_;
  Index first_corner_ = 0;
  // The displacement of a copy c is factor[c] times that of unknown[c], and what is given.
  std::vector<Index> unknown_;
  std::vector<Complex> factor_;
  Index num_unknowns_ = 0;
  HermitianCholesky cholesky_;
  Eigen::VectorXd stiffness_;  ///< F: factors on the energy
};

}  // namespace cirque
