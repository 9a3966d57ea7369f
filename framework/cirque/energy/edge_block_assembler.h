#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/energy.h"

namespace cirque {

/// A D A' for the A of angle constraints and a symmetric D over corners that couples a corner with
/// itself and with the one across its edge: the normal matrix of every solve of an angle fit.
class EdgeBlockAssembler {
 public:
  /// The constraints' triangulation must outlive the assembler.
  explicit EdgeBlockAssembler(const AngleConstraints& constraints);

  /// Adds to D_hg, where g is h or its twin; for the twin it must be called once more for D_gh.
  /// Calls for different h may be made at once.
  void Add(Index h, Index g, double weight) { (h == g ? own_ : shared_)[h] += weight; }

  /// Adds to a diagonal entry of the matrix itself.
  void AddToDiagonal(int row, double weight) {
    if (diagonal_.size() == 0) diagonal_.setZero(constraints_.num_rows());
    diagonal_[row] += weight;
  }

  /// The lower triangle; every diagonal entry and every entry between a triangle and its
  /// constrained vertices is stored, others where D has a coupling across the edge.
  void Assemble(SparseMatrix* lower) const;

  /// Forgets what was added, for the next of several matrices.
  void Clear();

  /// Assemble into the matrix that this very call, before Clear, has filled last (or an empty one):
  /// while D couples the same corners only values are written, the same to the last bit.
  void AssembleAgain(SparseMatrix* lower);

 private:
  class FaceColumn;

  /// Where a corner's weights go among the matrix' values; kNone: nowhere.
  struct Places {
    int own_vertex, other_face, other_vertex, vertices;
  };

  bool CouplesAsBefore() const;
  void FindPlaces(const SparseMatrix& lower);
  void FillPlaces(SparseMatrix* lower) const;

  void FillFaceColumns(SparseMatrix* lower) const;
  void FillVertexColumns(const std::vector<int>& coupling, SparseMatrix* lower) const;
  std::vector<int> CoupledVertices() const;
  int VertexColumn(Index h) const;
  int NumInColumn(Index f) const;
  double AddedToDiagonal(int row) const { return diagonal_.size() > 0 ? diagonal_[row] : 0; }

  const AngleConstraints& constraints_;
  const Triangulation& t_;
  Eigen::VectorXd own_, shared_;  ///< per corner: D_hh and D_hg
  Eigen::VectorXd diagonal_;      ///< what was added there; empty: nothing
  std::vector<Places> places_;    ///< per corner, of AssembleAgain; empty before it
  std::vector<int> coupling_;     ///< corners that couple two vertices, in the order of their sums
};

}  // namespace cirque
