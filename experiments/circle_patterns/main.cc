// The thesis's program: a triangle mesh in, its conformal map out.
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

#include "cirque/core/parallel.h"
#include "cirque/core/text.h"
#include "cirque/domains/domain.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/layout/map_objective.h"
#include "cirque/linear/blas_threads.h"
#include "cirque/linear/multigrid.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/rank_works.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/circle_patterns/flags.h"
#include "experiments/circle_patterns/job.h"
#include "experiments/common/process.h"
#include "experiments/common/program.h"
#include "experiments/common/solve_progress.h"

namespace cirque {
namespace {

int Conclude(const Status& status) {
  if (!status.ok()) std::cerr << "circle_patterns: " << status.message() << "\n";
  return ExitStatus(status.code());
}

/// Whether the input is a file of at most some 150,000 triangles. (A pipe, or what is packed, may have any
/// number.)
bool IsSmall(const CirclePatternsJob& job) {
  constexpr std::uintmax_t kSmallText = 6 << 20, kSmallFile = 4 << 20;
  const std::string& input = job.input_con.empty() ? job.input : job.input_con;
  const bool is_text = input.ends_with(".obj") || input.ends_with(".off");
  std::error_code none;  // with one the size is the largest
  const std::uintmax_t size = std::filesystem::file_size(input, none);
  return !input.ends_with(".gz") && size <= (is_text ? kSmallText : kSmallFile);
}

Status Run(const CirclePatternsJob& job, const SolveControl& control, std::ostream& report) {
  return job.input_con.empty() ? RunOnMesh(job, control, report)
                               : RunOnMetric(job, control, report);
}

int Main(int argc, char** argv) {
  const StatusOr<bool> served = ServeOtherRanks(AllRankWorks());
  if (!served.ok()) return Conclude(served.status());
  if (*served) return 0;
  CirclePatternsFlags flags;
  if (Status s = flags.Parse({argv + 1, argv + argc}); !s.ok()) return Conclude(s);
  if (const auto answered = AnswerQuestions(ProgramManual(), flags.line(), flags.others())) {
    return *answered;
  }
  if (flags.settings().certificate_help) {
    std::cout << CertificateReference();
    return 0;
  }
  const StatusOr<CirclePatternsJob> job = flags.Job();
  if (!job.ok()) return Conclude(job.status());
  const int threads = flags.settings().threads;
  const ThreadLimit limit(ReserveBlasBuffers(threads > 0 ? threads : ThreadsByEnvironment()));
  CatchInterrupts();
  if (IsSmall(*job)) KeepSmallHeap();
  const bool quiet = flags.settings().quiet;
  SolveProgress progress(quiet ? nullptr : stderr);
  std::ostream& out = job->output == "/dev/stdout" ? std::cerr : std::cout;
  std::ostream report(quiet ? nullptr : progress.Before(out));
  const Status status = Run(*job, progress.Control(InterruptFlag()), report);
  report.flush();
  progress.Erase();
  return Conclude(status);
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) {
  return cirque::RunMain("circle_patterns", argc, argv, cirque::Main);
}
