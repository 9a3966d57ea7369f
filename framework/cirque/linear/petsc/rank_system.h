#pragma once

#include <petscksp.h>

#include <vector>

#include "cirque/linear/multigrid.h"

namespace cirque {

/// Rows of a matrix, compressed by rows, whose columns increase.
struct MatrixRows {
  int size = 0;                 ///< of the whole matrix
  std::vector<PetscInt> start;  ///< number of rows + 1
  std::vector<PetscInt> column;
  std::vector<PetscScalar> value;

  int num_rows() const { return static_cast<int>(start.size()) - 1; }
};

/// Rows [first, last) of the symmetric matrix with that lower triangle.
MatrixRows ExtractRows(const LowerTriangleView& lower, int first, int last);

/// The methods of this PETSc: hypre's BoomerAMG where it is there, and PETSc's own GAMG.
const std::vector<std::string>& MultigridMethods();

/// One rank's part of a distributed system. Every function is collective and returns PETSc's error
/// code.
class RankSystem {
 public:
  explicit RankSystem(MPI_Comm comm) : comm_(comm) {}
  ~RankSystem();

  RankSystem(const RankSystem&) = delete;
  RankSystem& operator=(const RankSystem&) = delete;

  PetscErrorCode SetRows(const MatrixRows& rows);

  /// `method`: position in MultigridMethods().
  PetscErrorCode SetUp(int method);

  /// b and x: this rank's rows.
  PetscErrorCode Solve(const double* b, double target, int max_iterations, double* x,
                       MultigridResult* result);

 private:
  PetscErrorCode MakeSolver(int method);

  MPI_Comm comm_;
  int size_ = 0, num_rows_ = 0;  ///< of the matrix, and on this rank
  Mat matrix_ = nullptr;
  KSP solver_ = nullptr;
};

}  // namespace cirque
