// The thesis's program: a triangle mesh in, its conformal map out.
#include <iostream>

#include "cirque/core/parallel.h"
#include "cirque/core/text.h"
#include "cirque/domains/domain.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/layout/map_objective.h"
#include "cirque/linear/multigrid.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/circle_patterns/flags.h"
#include "experiments/circle_patterns/job.h"
#include "experiments/common/blas_threads.h"
#include "experiments/common/process.h"
#include "experiments/common/program.h"
#include "experiments/common/solve_progress.h"

namespace cirque {
namespace {

constexpr char kUsage[] =
    "Maps a triangle mesh conformally by a circle pattern.\n"
    "  circle_patterns -io IN.obj -oo OUT.obj\n"
    "  circle_patterns -ic IN.con -oo OUT.obj\n"
    "  circle_patterns -domain=sphere -io IN.obj -oo OUT.obj (or OUT.ply)\n"
    "  circle_patterns OPTIONS.txt           all options in one text file\n"
    "  mpirun -n 4 circle_patterns ...       -radii_solver=newton_amg distributed over processes\n"
    "Exit status: 0 done, 1 not converged, inaccurate or interrupted, 2 bad input or the machine "
    "failed, 3 infeasible (see its certificate), 4 unrepresentable.\n";

int Conclude(const Status& status) {
  if (!status.ok()) std::cerr << "circle_patterns: " << status.message() << "\n";
  return ExitStatus(status.code());
}

Status Run(const CirclePatternsJob& job, const SolveControl& control) {
  std::ostream& report = job.output == "/dev/stdout" ? std::cerr : std::cout;
  return job.input_con.empty() ? RunOnMesh(job, control, report)
                               : RunOnMetric(job, control, report);
}

int Main(int argc, char** argv) {
  const StatusOr<bool> served = ServeOtherRanks();
  if (!served.ok()) return Conclude(served.status());
  if (*served) return 0;
  CirclePatternsFlags flags;
  if (Status s = flags.Parse({argv + 1, argv + argc}); !s.ok()) return Conclude(s);
  if (flags.settings().help) {
    std::cout << kUsage << "\n" << flags.Help();
    return 0;
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
  SolveProgress progress(stderr);
  const SolveControl control{progress.Callback(), InterruptFlag()};
  const Status status = Run(*job, control);
  progress.Erase();
  return Conclude(status);
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) {
  return cirque::RunMain("circle_patterns", argc, argv, cirque::Main);
}
