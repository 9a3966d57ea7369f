#pragma once

#include <petscksp.h>

#include <string>
#include <vector>

#include "cirque/linear/multigrid.h"

namespace cirque {

/// Rows [first, last) of the symmetric matrix with that lower triangle.
MatrixRows ExtractRows(const LowerTriangleView& lower, int first, int last);

/// A hierarchy is made of many small blocks, whose memory the heap keeps when they are freed and
/// large blocks cannot use.
void ReturnFreedMemory();

/// The methods of this PETSc: hypre's BoomerAMG where it is there, and PETSc's own GAMG.
const std::vector<std::string>& MultigridMethods();

/// The position of that one, -1 when it is none of them.
int NumberOfMethod(const std::string& method);

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
