#pragma once

#include <deque>
#include <string>
#include <vector>

#include "experiments/run_experiment/run/child_process.h"
#include "experiments/run_experiment/run/ready_run.h"

namespace cirque {

/// A run that has ended.
struct EndedRun {
  std::string label;
  Record record;
};

/// Carries out runs in processes of their own, some side by side, and holds each to its
/// limits. A process that crashes (any end without a record) or exceeds a limit gives a record with
/// outcome "crash", "time_limit" or "memory_limit". Memory is looked at every few milliseconds, so
/// that a run may exceed its limit for so long.
class WorkerPool {
 public:
  /// `worker` is the command of a process that reads a packed run and prints its record.
  WorkerPool(int size, std::vector<std::string> worker);

  bool has_room() const { return static_cast<int>(active_.size()) < size_; }
  bool is_idle() const { return active_.empty(); }

  /// @pre has_room().
  Status Start(ReadyRun ready);

  /// The runs that have ended since the last call; waits a few milliseconds where there is none.
  std::vector<EndedRun> TakeEnded();

  /// Ends all runs that go on; they leave no record.
  void Abandon() { active_.clear(); }

 private:
  struct Active {
    ReadyRun ready;
    ChildProcess process;
    double peak_mib = 0;
  };

  std::vector<EndedRun> LookOnce();

  int size_;
  std::vector<std::string> worker_;
  std::deque<Active> active_;
};

/// The other side: reads a packed run from standard input, carries it out, prints its record with
/// the process' peak memory. Returns the process' exit status.
int RunWorker(const RunFunction& carry_out);

}  // namespace cirque
