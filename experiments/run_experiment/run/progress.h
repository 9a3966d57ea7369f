#pragma once

#include <cstdio>
#include <string>

#include "cirque/core/solve_summary.h"

#include "experiments/run_experiment/results/record.h"

namespace cirque {

/// Tells how far an experiment is: one line a run on `out`, and on a terminal also a line that is
/// overwritten, with how many runs are done, failed and left, and for about how long.
class Progress {
 public:
  /// `out` may be null: nothing is told. `total` counts all runs, `reused` those finished before.
  Progress(std::FILE* out, int total, int reused);

  void Start(const std::string& label);
  void Finish(const std::string& label, const Record& record);

 private:
  std::string State() const;

  std::FILE* out_;
  bool is_terminal_;
  int total_, reused_;
  int done_ = 0, failed_ = 0;
  Timer timer_;
};

}  // namespace cirque
