// The re-centred Newton method against Newton's method in ball coordinates: results/lorentz.md.
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>
#include <gflags/gflags.h>
#include <glog/logging.h>

#include "cirque/core/atomic_file.h"

#include "experiments/common/flag_parsing.h"
#include "experiments/lorentz_newton/study.h"

DEFINE_int32(points, 1000, "how many points crowd");
DEFINE_int32(seed, 1, "of their places");
DEFINE_string(output, "", "file for the table, Markdown; empty: standard output");
DECLARE_bool(help);

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/lorentz_newton/";
constexpr int kBadInput = 2;
constexpr int kScales = 13;  ///< 1 to 1e-12

int Refuse(const Status& status) {
  fmt::print(stderr, "lorentz_newton: {}\n", status.message());
  return kBadInput;
}

std::string Cells(const LorentzTrial& trial) {
  return fmt::format(" {} | {:.1e} | {} |", trial.iterations, trial.centre, trial.outcome);
}

std::string Table() {
  std::string text = fmt::format(
      "# Newton's method on the Lorentz energy\n\n"
      "Made by `lorentz_newton --output=results/lorentz.md`: {} points within `scale` of one "
      "direction, equal weights; converged where the gradient is at most 1e-14. *re-centred*: "
      "MinimizeLorentz; *line search*: the strategy `newton` in ball coordinates; *full steps*: "
      "the "
      "same without its line search, as in the thesis. *centre*: distance of the boosted points' "
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

int Main(int argc, char** argv) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_ERROR;
  google::InitGoogleLogging(argv[0]);
  const auto others = ParseFlags(argc, argv, kSource);
  if (!others.ok()) return Refuse(others.status());
  if (FLAGS_help) {
    fmt::print("lorentz_newton: centres crowded points on the sphere by three Newton methods\n\n{}",
               FlagHelp(kSource));
    return 0;
  }
  if (!others->empty() || FLAGS_points < 4) {
    return Refuse(Status::InvalidInput(FLAGS_points < 4 ? "-points: at least 4 are needed"
                                                        : "unexpected argument; see --help"));
  }
  if (FLAGS_output.empty()) {
    fmt::print("{}", Table());
    return 0;
  }
  const Status written = WriteFileAtomically(FLAGS_output, Table());
  return written.ok() ? 0 : Refuse(written);
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::Main(argc, argv); }
