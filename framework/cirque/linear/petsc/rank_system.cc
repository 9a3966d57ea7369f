#include "cirque/linear/petsc/rank_system.h"

#include <algorithm>
#include <type_traits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace cirque {
namespace {

static_assert(std::is_same_v<PetscInt, int> && std::is_same_v<PetscScalar, double>);

constexpr char kPrefix[] = "cirque_";
constexpr char kBoomerAmg[] = "boomeramg";

/// Sets an option unless the user has.
PetscErrorCode SetDefault(const char* name, const char* value) {
  PetscBool given = PETSC_FALSE;
  PetscCall(PetscOptionsHasName(nullptr, kPrefix, name, &given));
  if (given) return 0;
  const std::string full = std::string("-") + kPrefix + (name + 1);
  return PetscOptionsSetValue(nullptr, full.c_str(), value);
}

/// Coarsening and interpolation that keep the hierarchy small: De Sterck, Yang & Heys, SIAM J.
/// Matrix Anal. Appl. 27 (2006); De Sterck, Falgout, Nolting & Yang, Numer. Linear Algebra Appl. 15
/// (2008). A fifth faster than the defaults on dual Laplacians, at a sixth less memory.
PetscErrorCode SetBoomerAmgDefaults() {
  PetscCall(SetDefault("-pc_hypre_boomeramg_coarsen_type", "HMIS"));
  PetscCall(SetDefault("-pc_hypre_boomeramg_interp_type", "ext+i"));
  return SetDefault("-pc_hypre_boomeramg_P_max", "4");
}

PetscErrorCode ChooseMethod(PC preconditioner, const std::string& method) {
  if (method != kBoomerAmg) return PCSetType(preconditioner, PCGAMG);
#ifdef PETSC_HAVE_HYPRE
  PetscCall(PCSetType(preconditioner, PCHYPRE));
  PetscCall(PCHYPRESetType(preconditioner, kBoomerAmg));
#endif
  return SetBoomerAmgDefaults();
}

/// A vector of these local elements, which it uses in place.
PetscErrorCode WrapVector(MPI_Comm comm, int num_rows, int size, const double* values,
                          Vec* vector) {
  int num_ranks = 1;
  MPI_Comm_size(comm, &num_ranks);
  return num_ranks == 1 ? VecCreateSeqWithArray(comm, 1, size, values, vector)
                        : VecCreateMPIWithArray(comm, 1, num_rows, size, values, vector);
}

}  // namespace

void ReturnFreedMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

MatrixRows ExtractRows(const LowerTriangleView& lower, int first, int last) {
  MatrixRows rows;
  rows.size = lower.size;
  rows.start.assign(last - first + 1, 0);
  // Column by column, so that each row's entries come in the order of their columns.
  const auto for_each = [&](const auto& visit) {
    for (int j = 0; j < lower.size; ++j) {
      for (int p = lower.column_start[j]; p < lower.column_start[j + 1]; ++p) {
        const int i = lower.row[p];
        if (i >= first && i < last) visit(i - first, j, lower.value[p]);
        if (i != j && j >= first && j < last) visit(j - first, i, lower.value[p]);
      }
    }
  };
  for_each([&](int row, int, double) { ++rows.start[row + 1]; });
  for (int i = 0; i < last - first; ++i) rows.start[i + 1] += rows.start[i];
  rows.column.resize(rows.start.back());
  rows.value.resize(rows.start.back());
  std::vector<PetscInt> next(rows.start.begin(), rows.start.end() - 1);
  for_each([&](int row, int column, double value) {
    rows.column[next[row]] = column;
    rows.value[next[row]++] = value;
  });
  return rows;
}

const std::vector<std::string>& MultigridMethods() {
#ifdef PETSC_HAVE_HYPRE
  static const std::vector<std::string> kMethods = {kBoomerAmg, "gamg"};
#else
  static const std::vector<std::string> kMethods = {"gamg"};
#endif
  return kMethods;
}

int NumberOfMethod(const std::string& method) {
  const auto& methods = MultigridMethods();
  const auto found = std::find(methods.begin(), methods.end(), method);
  return found == methods.end() ? -1 : static_cast<int>(found - methods.begin());
}

RankSystem::~RankSystem() {
  KSPDestroy(&solver_);
  MatDestroy(&matrix_);
  ReturnFreedMemory();
}

PetscErrorCode RankSystem::SetRows(const MatrixRows& rows) {
  ReturnFreedMemory();  // of whatever the rows were made from
  const bool same_size = matrix_ && rows.size == size_;
  if (!same_size) PetscCall(KSPDestroy(&solver_));
  PetscCall(MatDestroy(&matrix_));
  size_ = rows.size;
  num_rows_ = rows.num_rows();
  PetscCall(MatCreate(comm_, &matrix_));
  PetscCall(MatSetSizes(matrix_, num_rows_, num_rows_, size_, size_));
  PetscCall(MatSetType(matrix_, MATAIJ));
  // Of the two the one for another number of ranks does nothing.
  PetscCall(MatSeqAIJSetPreallocationCSR(matrix_, rows.start.data(), rows.column.data(),
                                         rows.value.data()));
  PetscCall(MatMPIAIJSetPreallocationCSR(matrix_, rows.start.data(), rows.column.data(),
                                         rows.value.data()));
  PetscCall(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
  if (!solver_) return 0;
  PetscCall(KSPSetOperators(solver_, matrix_, matrix_));
  return KSPSetReusePreconditioner(solver_, PETSC_TRUE);
}

PetscErrorCode RankSystem::SetUp(int method) {
  // The old hierarchy goes first: two of them may not fit into memory.
  PetscCall(KSPDestroy(&solver_));
  PetscCall(MakeSolver(method));
  PetscCall(KSPSetUp(solver_));
  ReturnFreedMemory();
  return 0;
}

PetscErrorCode RankSystem::MakeSolver(int method) {
  PetscCall(KSPCreate(comm_, &solver_));
  PetscCall(KSPSetOptionsPrefix(solver_, kPrefix));
  PetscCall(KSPSetType(solver_, KSPCG));
  PetscCall(KSPSetNormType(solver_, KSP_NORM_UNPRECONDITIONED));
  PetscCall(KSPSetInitialGuessNonzero(solver_, PETSC_TRUE));
  PC preconditioner;
  PetscCall(KSPGetPC(solver_, &preconditioner));
  PetscCall(ChooseMethod(preconditioner, MultigridMethods()[method]));
  PetscCall(KSPSetOperators(solver_, matrix_, matrix_));
  return KSPSetFromOptions(solver_);
}

PetscErrorCode RankSystem::Solve(const double* b, double target, int max_iterations, double* x,
                                 MultigridResult* result) {
  Vec right_side, solution;
  PetscCall(WrapVector(comm_, num_rows_, size_, b, &right_side));
  PetscCall(WrapVector(comm_, num_rows_, size_, x, &solution));
  // The relative test is off: the target alone counts.
  constexpr double kOff = 1e-200;
  PetscCall(KSPSetTolerances(solver_, kOff, target, PETSC_DEFAULT, max_iterations));
  PetscCall(KSPSolve(solver_, right_side, solution));
  KSPConvergedReason reason;
  PetscCall(KSPGetConvergedReason(solver_, &reason));
  PetscCall(KSPGetIterationNumber(solver_, &result->iterations));
  result->converged = reason > 0;
  PetscCall(VecDestroy(&right_side));
  return VecDestroy(&solution);
}

}  // namespace cirque
