#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <thread>

#include "cirque/core/solve_summary.h"

namespace cirque {

/// Tells on one line of a terminal which stage a long run is in, its latest iterate and how long it
/// has taken; silent where `out` is no terminal. The line is drawn by a thread of its own, so that
/// it lives in stages that iterate over nothing, from a quarter of a second on.
class SolveProgress {
 public:
  /// `out` may be null: silent.
  explicit SolveProgress(std::FILE* out);
  ~SolveProgress();
  SolveProgress(const SolveProgress&) = delete;
  SolveProgress& operator=(const SolveProgress&) = delete;

  /// What a solve is to be given: this must outlive it. Stages and iterates may come from several
  /// threads, the latest is shown.
  SolveControl Control(const std::atomic<bool>* cancelled = nullptr);

  /// A stream's buffer for `out`, before each line of which the line of progress is erased.
  std::streambuf* Before(std::ostream& out);

  /// Draws the line, erases it.
  void Draw();
  void Erase();

 private:
  class ReportBuffer;

  void Begin(std::string_view stage);
  void Note(const IterationRecord& record);
  void Tick(std::stop_token stop);
  void EraseLocked();

  std::FILE* out_;  ///< null: silent
  Timer timer_;
  std::mutex mutex_;
  bool is_drawn_ = false;
  std::string stage_ = "reading";
  std::optional<IterationRecord> record_;  ///< of this stage
  std::unique_ptr<ReportBuffer> report_;
  std::condition_variable_any woken_;
  std::jthread ticker_;  ///< the last to come and the first to go
};

/// "radii, iteration 12, gradient 3.4e-05, 7.2 s"; without a record "layout, 7.2 s".
std::string ProgressText(std::string_view stage, const IterationRecord* record, double seconds);

}  // namespace cirque
