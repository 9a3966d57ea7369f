#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// The lower triangle of a symmetric matrix, compressed by columns, whose rows increase.
struct LowerTriangleView {
  int size = 0;
  const int* column_start = nullptr;  ///< size + 1
  const int* row = nullptr;
  const double* value = nullptr;
};

/// How conjugate gradients ended.
struct MultigridResult {
  int iterations = 0;
  bool converged = false;  ///< |A x - b| <= target
};

/// One linear system after another, by conjugate gradients preconditioned with algebraic multigrid.
/// Every function but the constructor returns false when the library fails, for which error() says
/// why.
class MultigridSystem {
 public:
  virtual ~MultigridSystem() = default;

  virtual bool SetMatrix(const LowerTriangleView& lower) = 0;

  /// Makes the hierarchy of the present matrix, `method` an element of MultigridMethods(). Later
  /// matrices of that size use it too.
  virtual bool SetUp(const std::string& method) = 0;

  /// Iterates from *x until |A x - b| <= target. @pre SetUp was called; b and *x have n elements.
  virtual bool Solve(const double* b, double target, int max_iterations, double* x,
                     MultigridResult* result) = 0;

  const std::string& error() const { return error_; }

 protected:
  std::string error_;
};

/// The library that does it, initialised.
class MultigridLibrary {
 public:
  virtual ~MultigridLibrary() = default;
  virtual std::unique_ptr<MultigridSystem> MakeSystem() = 0;
  virtual std::vector<std::string> Methods() const = 0;  ///< the first is the default

  /// Processes that the systems are distributed over.
  virtual int num_ranks() const = 0;

  /// On a rank other than the first: solves its part of what the first does, until that is done.
  virtual void Serve() = 0;
  virtual bool is_first_rank() const = 0;
};

/// Whether Cirque was built with PETSc.
bool BuiltWithMultigrid();

/// What to do about it.
Status MultigridNotBuilt();

/// PETSc, loaded and initialised at the first call of this or ServeOtherRanks, on this process
/// alone unless it was the latter. Programs that never solve by multigrid never load it: a hundred
/// libraries come with it.
StatusOr<MultigridLibrary*> LoadMultigrid();

/// To be called first by a program that mpirun may have started several times. On the first rank,
/// or where there is one: false, and the program goes on; LoadMultigrid then has all ranks at its
/// service. On the others: true, when the first has ended, and the program shall end too.
StatusOr<bool> ServeOtherRanks();

}  // namespace cirque
