#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "cirque/linear/petsc/mpi_ranks.h"
#include "cirque/linear/petsc/rank_system.h"
#include "cirque/linear/petsc/session.h"

namespace cirque {

/// What all ranks do next.
struct RankCommand {
  enum Operation : int { kSetMatrix, kSetUp, kSolve, kRelease, kBegin, kDo, kEnd, kStop };
  Operation operation = kStop;
  int system = 0;  ///< which of the first rank's systems and works
  int size = 0;    ///< of it
  int method = 0;  ///< of kSetUp
  int work = 0;    ///< of kBegin: position among the works
  int task = 0;    ///< of kDo
  int max_iterations = 0;
  double target = 0;
};

/// What only the first rank has.
struct RankData {
  LowerTriangleView lower;
  const double* right_side = nullptr;
  double* solution = nullptr;
  MultigridResult* result = nullptr;
};

/// The ranks that work together. They have parts of works, of which the team knows the names only,
/// and of systems that the first has whole: rank r of R has the rows [n r / R, n (r + 1) / R). The
/// first rank commands, hands out rows and right sides, and collects solutions; the others wait for
/// commands, asleep most of the time. An error that one rank alone may have seen ends the processes
/// of all (MPI_Abort): the others could wait for it for ever.
class RankTeam {
 public:
  explicit RankTeam(const PetscSession& session) : session_(session), ranks_(session) {}

  /// What Begin may name; of the first call.
  void SetWorks(const RankWorks& works) {
    if (known_works_.empty()) known_works_ = works;
  }

  /// On the first rank: all begin a work. Its own part; null where it is not known.
  RankWork* Begin(const std::string& work, int number);

  /// On the first rank: all do it. False on an error, which there is only without other ranks.
  bool Run(const RankCommand& command, const RankData& data, std::string* error);

  /// On the first rank: sends the others home.
  void Stop();

  /// On the others: obeys until sent home.
  void Serve();

  const PetscSession& session() const { return session_; }

 private:
  int FirstRow(int rank, int size) const;
  std::vector<int> RowCounts(int size) const;
  void Announce(RankCommand command);
  RankCommand Await();
  bool Obey(const RankCommand& command, const RankData& data, std::string* error);
  PetscErrorCode Execute(const RankCommand& command, const RankData& data);
  PetscErrorCode Solve(const RankCommand& command, const RankData& data, RankSystem* system);
  void DoWork(const RankCommand& command);
  MatrixRows HandOutRows(const LowerTriangleView& lower);
  MatrixRows ReceiveRows(int size);

  const PetscSession& session_;
  std::mutex mutex_;  ///< PETSc serves one thread at a time
  std::map<int, std::unique_ptr<RankSystem>> systems_;
  MpiRanks ranks_;
  RankWorks known_works_;
  std::map<int, std::unique_ptr<RankWork>> works_;
};

}  // namespace cirque
