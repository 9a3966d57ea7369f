// The re-centred Newton method against Newton's method in ball coordinates: results/lorentz.md.
#include <fmt/format.h>
#include <gflags/gflags.h>

#include "experiments/studies/lorentz_trials.h"
#include "experiments/studies/studies.h"

DEFINE_int32(points, 1000, "how many points crowd");
DEFINE_int32(seed, 1, "of their places");

namespace cirque {
namespace {

constexpr int kScales = 13;  ///< 1 to 1e-12

std::string Cells(const LorentzTrial& trial) {
  return fmt::format(" {} | {:.1e} | {} |", trial.iterations, trial.centre, trial.outcome);
}

std::string Table() {
  std::string text = fmt::format(
      "# Newton's method on the Lorentz energy\n\n"
      "Made by `studies lorentz --output=results/lorentz.md`: {} points within `scale` of one "
      "direction, equal weights; converged where the gradient is at most 1e-14. *re-centred*: "
      "MinimizeLorentz; *line search*: the strategy `newton` in ball coordinates; *full steps*: "
      "the same without its line search, as in the thesis. *centre*: distance of the boosted "
      "points' "
      "centre of mass from 0.\n\n"
      "| scale | re-centred steps | centre | outcome | line search steps | centre | outcome | full "
      "steps | centre | outcome |\n|--:|--:|--:|---|--:|--:|---|--:|--:|---|\n",
      FLAGS_points);
  double scale = 1;
  for (int i = 0; i < kScales; ++i, scale /= 10) {
    const auto points = Crowd(FLAGS_points, scale, static_cast<unsigned>(FLAGS_seed));
    text += fmt::format("| {:.0e} |", scale) + Cells(RecentredNewton(points)) +
            Cells(NewtonInBall(points)) + Cells(FullNewtonInBall(points)) + "\n";
  }
  return text;
}

}  // namespace

Status RunLorentz(const StudyCall& call) {
  if (Status s = NoArguments(call); !s.ok()) return s;
  if (FLAGS_points < 4) return Status::InvalidInput("--points: at least 4 are needed");
  return Deliver(Table());
}

}  // namespace cirque
