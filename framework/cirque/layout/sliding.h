#pragma once

#include <complex>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"
#include "cirque/linear/hermitian_cholesky.h"
#include "cirque/linear/sparse_cholesky.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {

/// Boundary vertices of a map that may move along the boundary of its image, and in no other way:
/// on straight sides, or on the unit circle about 0.
struct SlidingVertices {
  std::vector<bool> slides;  ///< for every vertex of the surface; empty: none does
  /// For every vertex, the side's direction as the boundary runs (the surface on its left), of
  /// absolute value 1; of those that do not slide without meaning. Empty: on the circle.
  std::vector<std::complex<double>> direction;
};

/// A vertex that slides, with the direction of its side; 0: on the unit circle.
struct Rail {
  Index vertex;
  std::complex<double> direction;

  bool IsCircle() const { return direction == 0.0; }

  /// Where a vertex at z goes: a unit vector.
  std::complex<double> Tangent(std::complex<double> z) const {
    return IsCircle() ? std::complex<double>(-z.imag(), z.real()) : direction;
  }

  /// z moved by a signed distance along the rail, on it to rounding; a side parallel to the real
  /// axis is kept exactly.
  std::complex<double> Move(std::complex<double> z, double distance) const;
};

/// A boundary edge at a vertex that slides, with the direction of that vertex's side; 0: on the
/// circle.
struct RimEdge {
  Index tail, tip;
  std::complex<double> direction;

  /// Whether the edge between these points runs as the boundary does; on the circle by less than
  /// half of it, exactly.
  bool RunsBetween(std::complex<double> from, std::complex<double> to) const;
};

/// Systems A x = b with a Hermitian positive definite A, solved among the x whose entries on rails
/// are real multiples of given tangents: the minimum there of
///   x* A x / 2 - Re(b* x),
/// a symmetric system in one real unknown for each such entry and two for the others.
class SlidingCholesky {
 public:
  /// `rails` in the order of their vertices, which are numbers of unknowns.
  SlidingCholesky(const std::vector<Rail>& rails, Index unknowns);

  /// A by its lower triangle, and a tangent of absolute value 1 for every rail. False when A is not
  /// positive definite in floating point. @pre the pattern is that of the call before.
  bool Factorize(const ComplexSparseMatrix& lower, std::vector<std::complex<double>> tangents);

  /// @pre Factorize returned true.
  Eigen::VectorXcd Solve(const Eigen::VectorXcd& right_side) const;

 private:
  using Complex = std::complex<double>;

  bool Slides(Index v) const { return rail_[v] != kNone; }
  void AddEntry(Index i, Index j, Complex value,
                std::vector<Eigen::Triplet<double>>* entries) const;

  std::vector<Index> rail_, first_;  ///< per unknown: its rail or kNone, its first real unknown
  Index size_ = 0;                   ///< real unknowns
  std::vector<Complex> tangents_;
  std::unique_ptr<SparseCholesky> cholesky_;
};

}  // namespace cirque
