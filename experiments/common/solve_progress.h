#pragma once

#include <cstdio>
#include <string>

#include "cirque/core/solve_summary.h"

namespace cirque {

/// Tells on one line of a terminal, overwritten at every iterate, how far a long solve is. Silent
/// for the first second, and altogether where `out` is no terminal.
class SolveProgress {
 public:
  /// `out` may be null.
  explicit SolveProgress(std::FILE* out);
  ~SolveProgress() { Erase(); }
  SolveProgress(const SolveProgress&) = delete;
  SolveProgress& operator=(const SolveProgress&) = delete;

  /// Watches a solve by this; the line is erased when this goes. This must outlive the callback.
  IterationCallback Callback();

  /// Draws the line, erases it.
  void Draw(const IterationRecord& record);
  void Erase();

 private:
  std::FILE* out_;  ///< null: silent
  bool is_drawn_ = false;
  Timer timer_;
};

/// "iteration 12, gradient 3.4e-05, 1.2 s".
std::string ProgressText(const IterationRecord& record);

}  // namespace cirque
