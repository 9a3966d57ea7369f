#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/io/io.h"
#include "cirque/verify/map_check.h"

#include "experiments/common/judged_measures.h"
#include "experiments/common/process.h"
#include "experiments/run_experiment/run/carry_out.h"
#include "experiments/run_experiment/run/child_process.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

// Between two looks at a program: short at first, for programs that end at once.
constexpr std::chrono::microseconds kFirstPause(100), kLongestPause(2000);
constexpr std::size_t kLastWords = 300;  ///< of a program that failed, in the message
constexpr std::size_t kMostErrors = 3;   ///< of a wrong map, in the message

/// A folder of its own, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "cirque-peer-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code error;
    if (!path_.empty()) fs::remove_all(path_, error);
  }
  bool exists() const { return !path_.empty(); }
  std::string Path(const std::string& name) const { return (fs::path(path_) / name).string(); }

 private:
  std::string path_;
};

std::string Replaced(std::string word, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = word.find(what, at)) != std::string::npos; at += with.size()) {
    word.replace(at, what.size(), with);
  }
  return word;
}

std::string LastWords(const ChildProcess& process) {
  for (const std::string& said : {process.Errors(), process.Output()}) {
    const std::size_t end = said.find_last_not_of(" \r\n");
    if (end == std::string::npos) continue;
    const std::string text = said.substr(0, end + 1);
    return "; it said: " + text.substr(text.size() > kLastWords ? text.size() - kLastWords : 0);
  }
  return "";
}

/// Waits for the program, which it ends at a limit; the outcome where that was needed.
std::optional<std::string> Await(const RunLimits& limits, ChildProcess* process, double* peak_mib) {
  for (auto pause = kFirstPause; !process->HasEnded(); pause = std::min(2 * pause, kLongestPause)) {
    *peak_mib = std::max(*peak_mib, process->ResidentMib());
    const bool too_long = limits.seconds > 0 && process->Seconds() > limits.seconds;
    const bool too_large = limits.memory_mib > 0 && *peak_mib > limits.memory_mib;
    if (too_long || too_large) {
      process->Kill();
      return too_long ? kTimeLimit : kMemoryLimit;
    }
    std::this_thread::sleep_for(pause);
  }
  return std::nullopt;
}

void SetOutcome(const std::string& outcome, const std::string& message, RunResult* result) {
  result->certificate.outcome = outcome;
  result->certificate.message = message;
}

/// Runs the program to its end; whether it ended well is the outcome, times and memory are its own.
Status RunProgram(const PlannedRun& run, const std::vector<std::string>& command,
                  RunResult* result) {
  const double own_mib = PeakMemoryMib();
  StatusOr<ChildProcess> process =
      ChildProcess::Start(command, "", ChildProcess::Kin::kWithOwnChildren);
  if (!process.ok()) return process.status();
  double peak_mib = 0;
  const Timer timer;
  std::optional<std::string> ended_at = Await(run.limits, &*process, &peak_mib);
  result->seconds = timer.Seconds();
  result->cpu_seconds = result->map_cpu_seconds = process->CpuSeconds();
  // A process counts what it was before it became the program: this one's.
  const double peak_by_system = process->PeakMib();
  result->peak_memory_mib =
      peak_by_system > own_mib ? std::max(peak_by_system, peak_mib) : peak_mib;
  // The last moments can pass between two looks at it.
  const double most_mib = run.limits.memory_mib;
  if (!ended_at && most_mib > 0 && result->peak_memory_mib > most_mib) ended_at = kMemoryLimit;
  if (ended_at) {
    SetOutcome(*ended_at, fmt::format("'{}' was ended at its limit", command[0]), result);
  } else if (!process->Succeeded()) {
    SetOutcome(
        kPeerFailed,
        fmt::format("'{}' ended by {}{}", command[0], process->HowItEnded(), LastWords(*process)),
        result);
  } else {
    SetOutcome(ToString(StatusCode::kOk), "", result);
  }
  return Status();
}

void SetFigures(const verify::MapReport& report, const PolygonSoup& triangles, RunResult* result) {
  std::map<std::string, double>& figures = result->figures;
  if (report.orientations) {
    figures["flipped_triangles"] = static_cast<double>(report.orientations->flipped.size());
    figures["degenerate_faces"] = static_cast<double>(report.orientations->zero_area.size());
  }
  if (!report.complex) return;
  const bool injective = report.overlap && !report.overlap->overlaps();
  const MapMeasures measures =
      verify::MeasureComplex(*report.complex, triangles.position, injective);
  for (const MapMeasures::Figure& figure : measures.figures) figures[figure.name] = figure.value;
}

/// What the independent judge says of the map.
Status Judge(const PlannedRun& run, const PolygonSoup& triangles, const std::string& file,
             RunResult* result) {
  StatusOr<PolygonSoup> mapped = ReadMesh(file);
  if (!mapped.ok()) {
    SetOutcome(kPeerFailed, "what it wrote: " + mapped.status().message(), result);
    return Status();
  }
  const StatusOr<verify::MapReport> report = verify::VerifyMap(triangles, *mapped, {});
  if (!report.ok()) return report.status();
  SetFigures(*report, triangles, result);
  if (report->overlap) {
    result->certificate.overlap = report->overlap->overlaps() ? kOverlaps : kInjective;
  }
  if (!report->valid()) {
    std::vector<std::string> errors = report->errors;
    if (errors.size() > kMostErrors) errors.resize(kMostErrors);
    SetOutcome(kInvalidMap, Join(errors, "; "), result);
  }
  if (run.keep_map) result->map = *std::move(mapped);
  return Status();
}

}  // namespace

Status PeerRun(const PlannedRun& run, const PolygonSoup& triangles, RunResult* result) {
  const ScratchFolder folder;
  if (!folder.exists()) return {StatusCode::kResource, "no folder for a peer's files can be made"};
  const std::string in = folder.Path("in.obj"), out = folder.Path("out.obj");
  if (Status s = WriteMesh(in, triangles); !s.ok()) return s;
  std::vector<std::string> command = run.method.peer;
  for (std::string& word : command) word = Replaced(Replaced(word, "{in}", in), "{out}", out);
  if (Status s = RunProgram(run, command, result); !s.ok()) return s;
  if (result->certificate.outcome != ToString(StatusCode::kOk)) return Status();
  return Judge(run, triangles, out, result);
}

}  // namespace cirque
