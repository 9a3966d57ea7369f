#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/linear/ranks.h"

namespace cirque {

/// The lower triangle of a symmetric matrix, compressed by columns, whose rows increase.
struct LowerTriangleView {
  int size = 0;
  const int* column_start = nullptr;  ///< size + 1
  const int* row = nullptr;
  const double* value = nullptr;
};

/// Rows of a symmetric matrix, one behind another, compressed by rows, whose columns increase.
struct MatrixRows {
  int size = 0;            ///< of the whole matrix
  std::vector<int> start;  ///< number of rows + 1
  std::vector<int> column;
  std::vector<double> value;

  int num_rows() const { return static_cast<int>(start.size()) - 1; }
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

  /// Makes the hierarchy of the present matrix, `method` an element of MultigridMethods(). Later
  /// matrices of that size use it too.
  virtual bool SetUp(const std::string& method) = 0;

  /// Iterates from *x until |A x - b| <= target. @pre SetUp was called; b and *x have as many
  /// elements as the matrix, or this rank's part of it, has rows.
  virtual bool Solve(const double* b, double target, int max_iterations, double* x,
                     MultigridResult* result) = 0;

  const std::string& error() const { return error_; }

 protected:
  std::string error_;
};

/// One that the first rank has whole and hands out.
class WholeSystem : public MultigridSystem {
 public:
  virtual bool SetMatrix(const LowerTriangleView& lower) = 0;
};

/// One of which every rank has its rows: all functions are collective (Ranks).
class SharedSystem : public MultigridSystem {
 public:
  virtual bool SetRows(const MatrixRows& rows) = 0;
};

/// The library that does it, initialised.
class MultigridLibrary {
 public:
  virtual ~MultigridLibrary() = default;
  virtual std::unique_ptr<WholeSystem> MakeSystem() = 0;
  virtual std::vector<std::string> Methods() const = 0;  ///< the first is the default

  /// Processes that the systems are distributed over.
  virtual int num_ranks() const = 0;

  /// On a rank other than the first: does its part of what the first does, until that is done.
  virtual void Serve() = 0;

  /// What Begin may name, on every rank the same; of the first call.
  virtual void SetWorks(const RankWorks& works) = 0;

  /// On the first rank: all begin, do a task of, and end a work; Begin gives the number and the
  /// first's own part, null where the program's ranks do not know the work.
  virtual RankWork* Begin(const std::string& work, int* number) = 0;
  virtual void Do(int number, int task) = 0;
  virtual void End(int number) = 0;
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

/// Several ranks that are at this process' service; null where there are none.
MultigridLibrary* RanksAtService();

/// To be called first by a program that mpirun may have started several times. On the first rank,
/// or where there is one: false, and the program goes on; LoadMultigrid then has all ranks at its
/// service, which know `works`. On the others: true, when the first has ended, and the program shall
/// end too.
StatusOr<bool> ServeOtherRanks(const RankWorks& works);

/// A work of all ranks as the first sees it, while this lives; W is the class of its parts.
template <class W>
class SharedWork {
 public:
  SharedWork(MultigridLibrary* library, const std::string& name)
      : library_(*library), part_(static_cast<W*>(library->Begin(name, &number_))) {}
  ~SharedWork() {
    if (part_) library_.End(number_);
  }
  SharedWork(const SharedWork&) = delete;
  SharedWork& operator=(const SharedWork&) = delete;

  /// Whether the program's ranks know it.
  bool IsKnown() const { return part_ != nullptr; }

  W& part() { return *part_; }  ///< the first rank's
  void Do(int task) { library_.Do(number_, task); }

 private:
  MultigridLibrary& library_;
  int number_ = 0;
  W* part_;
};

}  // namespace cirque
