// What Cirque loads where it was built with PETSc: see linear/multigrid.h.
#include <atomic>

#include "cirque/linear/petsc/rank_team.h"

namespace cirque {
namespace {

class PetscSystem final : public WholeSystem {
 public:
  PetscSystem(int number, RankTeam* team) : number_(number), team_(*team) {}

  ~PetscSystem() override { Run({RankCommand::kRelease}, {}); }

  bool SetMatrix(const LowerTriangleView& lower) override {
    size_ = lower.size;
    return Run({RankCommand::kSetMatrix}, {.lower = lower});
  }

  bool SetUp(const std::string& method) override {
    RankCommand command{RankCommand::kSetUp};
    command.method = NumberOfMethod(method);
    if (command.method < 0) {
      error_ = "this PETSc has no '" + method + "'";
      return false;
    }
    return Run(command, {});
  }

  bool Solve(const double* b, double target, int max_iterations, double* x,
             MultigridResult* result) override {
    RankCommand command{RankCommand::kSolve};
    command.target = target;
    command.max_iterations = max_iterations;
    return Run(command, {{}, b, x, result});
  }

 private:
  bool Run(RankCommand command, const RankData& data) {
    command.system = number_;
    command.size = size_;
    return team_.Run(command, data, &error_);
  }

  const int number_;
  RankTeam& team_;
  int size_ = 0;
};

class PetscLibrary final : public MultigridLibrary {
 public:
  explicit PetscLibrary(bool all_ranks) : session_(all_ranks), team_(session_) {}

  ~PetscLibrary() override {
    if (session_.IsOwner() && is_first_rank()) team_.Stop();
  }

  std::unique_ptr<WholeSystem> MakeSystem() override {
    return std::make_unique<PetscSystem>(++num_systems_, &team_);
  }

  std::vector<std::string> Methods() const override { return MultigridMethods(); }
  int num_ranks() const override { return session_.num_ranks(); }
  void Serve() override { team_.Serve(); }
  void SetWorks(const RankWorks& works) override { team_.SetWorks(works); }
  RankWork* Begin(const std::string& work, int* number) override {
    *number = ++num_systems_;
    return team_.Begin(work, *number);
  }
  void Do(int number, int task) override { RunTask(RankCommand::kDo, number, task); }
  void End(int number) override { RunTask(RankCommand::kEnd, number, 0); }
  bool is_first_rank() const override { return session_.rank() == 0; }
  const std::string& error() const { return session_.error(); }

 private:
  /// An error ends all ranks.
  void RunTask(RankCommand::Operation operation, int number, int task) {
    RankCommand command{operation, number};
    command.task = task;
    std::string none;
    team_.Run(command, {}, &none);
  }

  PetscSession session_;
  RankTeam team_;
  std::atomic<int> num_systems_ = 0;  ///< and works
};

}  // namespace

// Null with the reason in *error where PETSc cannot be initialised. The first call's ranks count.
extern "C" MultigridLibrary* CirqueMultigridLibrary(bool all_ranks, std::string* error) {
  static PetscLibrary library(all_ranks);
  *error = library.error();
  return error->empty() ? &library : nullptr;
}

}  // namespace cirque
