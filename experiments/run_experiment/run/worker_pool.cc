#include "experiments/run_experiment/run/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/parallel.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/linear/blas_threads.h"

#include "experiments/common/process.h"
#include "experiments/common/records.h"

namespace cirque {
namespace {

constexpr std::chrono::milliseconds kPause(3);
/// Who kills a cluster's job kills all its processes, one after the other: ours is given the time
/// to be next, before the end of a run is called a crash of its own.
constexpr std::chrono::milliseconds kNextToBeKilled(300);
constexpr std::size_t kLastWords = 500;  ///< of a crashed run, in its record

std::string LastWords(const std::string& errors) {
  const std::size_t end = errors.find_last_not_of(" \n");
  if (end == std::string::npos) return "";
  const std::string text = errors.substr(0, end + 1);
  return "; it said: " + text.substr(text.size() > kLastWords ? text.size() - kLastWords : 0);
}

/// What ends a peer is its worker, which knows how much of the time was the peer's.
constexpr double kSecondsToEndAPeer = 10;

/// The limits of a run's process.
RunLimits LimitsOf(const PlannedRun& run) {
  RunLimits limits = run.limits;
  if (!run.method.peer.empty() && limits.seconds > 0) limits.seconds += kSecondsToEndAPeer;
  return limits;
}

std::optional<std::string> ExceededLimit(const RunLimits& limits, double seconds, double mib) {
  if (limits.seconds > 0 && seconds > limits.seconds) return kTimeLimit;
  if (limits.memory_mib > 0 && mib > limits.memory_mib) return kMemoryLimit;
  return std::nullopt;
}

std::string LimitMessage(const std::string& outcome, const RunLimits& limits, double mib) {
  if (outcome == kTimeLimit) return fmt::format("ended at its limit of {} s", limits.seconds);
  return fmt::format("ended at {:.0f} MiB, its limit is {} MiB", mib, limits.memory_mib);
}

Record LimitRecord(const ReadyRun& ready, const std::string& outcome, double seconds, double mib) {
  Record record =
      FailedRecord(ready, outcome, LimitMessage(outcome, ready.run.limits, mib), seconds);
  record["peak_memory_mib"] = mib;
  return record;
}

Record CrashRecord(const ReadyRun& ready, const ChildProcess& process) {
  if (process.WasKilled()) std::this_thread::sleep_for(kNextToBeKilled);
  const std::string message = fmt::format("the run's process ended by {} without a record{}",
                                          process.HowItEnded(), LastWords(process.Errors()));
  return FailedRecord(ready, process.WasKilled() ? kKilled : kCrash, message, process.Seconds());
}

Record RecordOf(const ReadyRun& ready, const ChildProcess& process) {
  const std::optional<Record> parsed = ParseRecord(process.Output());
  const bool is_whole = process.Succeeded() && parsed && parsed->at("key") == ready.key;
  if (!is_whole) return CrashRecord(ready, process);
  const Record& record = *parsed;
  // The last moments of a run can pass between two looks at it.
  const double mib = NumberAt(record, "/peak_memory_mib");
  if (!ExceededLimit({0, ready.run.limits.memory_mib}, 0, mib)) return record;
  return LimitRecord(ready, kMemoryLimit, process.Seconds(), mib);
}

std::string ReadStandardInput() {
  std::string bytes;
  char block[1 << 12];
  while (const std::size_t size = std::fread(block, 1, sizeof(block), stdin)) {
    bytes.append(block, size);
  }
  return bytes;
}

}  // namespace

WorkerPool::WorkerPool(int size, std::vector<std::string> worker)
    : size_(size), worker_(std::move(worker)) {}

Status WorkerPool::Start(ReadyRun ready) {
  StatusOr<ChildProcess> process = ChildProcess::Start(worker_, PackRun(ready));
  if (!process.ok()) return process.status();
  active_.push_back({std::move(ready), *std::move(process)});
  return Status();
}

std::vector<EndedRun> WorkerPool::TakeEnded() {
  std::vector<EndedRun> ended = LookOnce();
  if (ended.empty()) std::this_thread::sleep_for(kPause);
  return ended;
}

std::vector<EndedRun> WorkerPool::LookOnce() {
  std::vector<EndedRun> ended;
  for (auto run = active_.begin(); run != active_.end();) {
    const RunLimits limits = LimitsOf(run->ready.run);
    run->peak_mib = std::max(run->peak_mib, run->process.ResidentMib());
    const double seconds = run->process.Seconds();
    std::optional<Record> record;
    if (run->process.HasEnded()) {
      record = RecordOf(run->ready, run->process);
    } else if (const auto outcome = ExceededLimit(limits, seconds, run->peak_mib)) {
      run->process.Kill();
      record = LimitRecord(run->ready, *outcome, seconds, run->peak_mib);
    }
    if (!record) {
      ++run;
      continue;
    }
    ended.push_back({run->ready.run.Label(), *std::move(record)});
    run = active_.erase(run);
  }
  return ended;
}

int RunWorker(const RunFunction& carry_out) {
  StatusOr<ReadyRun> ready = UnpackRun(ReadStandardInput());
  if (!ready.ok()) {
    fmt::print(stderr, "{}\n", ready.status().message());
    return 1;
  }
  const ThreadLimit limit(ReserveBlasBuffers(ThreadsByEnvironment()));
  ready->provenance["blas_threads"] = NumBlasThreads();
  ready->provenance["threads"] = NumThreads();
  const Timer timer;
  StatusOr<Record> record = CarryOut(*ready, carry_out);
  // The run itself went well; what it made could not be kept.
  if (!record.ok()) {
    record = FailedRecord(*ready, ToString(StatusCode::kResource), record.status().message(),
                          timer.Seconds());
  }
  if (!record->contains("peak_memory_mib")) (*record)["peak_memory_mib"] = PeakMemoryMib();
  fmt::print("{}\n", ToLine(*record));
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace cirque
