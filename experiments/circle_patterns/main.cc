// The thesis's program: a triangle mesh in, its conformal map out.
#include <fstream>
#include <iostream>

#include <gflags/gflags.h>
#include <glog/logging.h>

#include "cirque/core/text.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/circle_patterns/domains.h"
#include "experiments/circle_patterns/run.h"
#include "experiments/common/blas_threads.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/common/interrupt.h"
#include "experiments/common/solve_progress.h"

DEFINE_string(io, "", "input mesh: .obj, .off, .ply or .stl");
DEFINE_string(oo, "", "output .obj, with the map as texture coordinates");
DEFINE_string(oc, "", "output .con: the flat metric on the triangulation where it was solved");
DEFINE_string(ic, "", "input .con: an intrinsic metric, instead of -io");
DEFINE_bool(no, false, "no optimisation: cut and lay out the metric of -ic, which is flat already");
DEFINE_string(iv, "", "cone file: 'vertex min max' a line, angle sums in multiples of pi");
DEFINE_string(angle_sums, "", "file of one target angle sum in radians per vertex, instead of -iv");
DEFINE_string(ie, "", "edge-cut file: 'from to face' a line; without it a short cut is found");
DEFINE_bool(fill_holes, false,
            "close all boundary loops but the longest for the solve; the fill is not written");
DEFINE_string(triangulation, cirque::ParameterizeOptions().triangulation,
              "delaunay: intrinsic Delaunay flips first; input: the file's connectivity");
DEFINE_string(layout, cirque::ParameterizeOptions().layout, "directions or least_squares");
DEFINE_string(certificate, "", "file for the certificate; empty: OUTPUT.certificate.json");
DEFINE_string(angle_fit, cirque::ParameterizeOptions().angle_fit, "objective of the angle fit");
DEFINE_string(angle_strategy, cirque::ParameterizeOptions().angle_strategy,
              "solver of the angle fit");
DEFINE_string(strategy, cirque::ParameterizeOptions().strategy, "solver of the log radii");
DEFINE_double(epsilon, cirque::ParameterizeOptions().epsilon,
              "least corner and intersection angle in radians; shrinks where it must");
DEFINE_int32(max_iterations, cirque::ParameterizeOptions().max_iterations, "steps of each solve");
DEFINE_string(domain, cirque::DomainRequest().name,
              "shape to map onto: plane, disk, half_plane, rectangle, polygon, triangle");
DEFINE_string(centre, "", "disk: inner vertex that goes to 0, numbered from 0");
DEFINE_string(angle_zero, "", "disk: boundary vertex that goes to (1, 0), numbered from 0");
DEFINE_string(pole, "", "disk, half_plane: boundary vertex that the solve sends to infinity");
DEFINE_string(normalization, cirque::DomainRequest().normalization,
              "disk: boundary or area: instead of a vertex, a centre of mass goes to 0");
DEFINE_string(corners, "", "rectangle, polygon, triangle: boundary vertices, from 0, with commas");
DEFINE_int32(sides, 0, "polygon: how many corners to choose, where none are given (4)");
DECLARE_bool(help);

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/circle_patterns/";
constexpr char kUsage[] =
    "Flattens a triangle mesh conformally by a circle pattern.\n"
    "  circle_patterns -io IN.obj -oo OUT.obj\n"
    "  circle_patterns -ic IN.con -oo OUT.obj\n"
    "  circle_patterns OPTIONS.txt           all options in one text file\n"
    "Exit status: 0 done, 1 not converged, 2 bad input, 3 proven infeasible, 4 unrepresentable.\n";

int Conclude(const Status& status) {
  if (!status.ok()) std::cerr << "circle_patterns: " << status.message() << "\n";
  return ExitStatus(status.code());
}

CirclePatternsJob JobOfFlags() {
  CirclePatternsJob job;
  job.input = FLAGS_io;
  job.output = FLAGS_oo;
  job.input_con = FLAGS_ic;
  job.layout_only = FLAGS_no;
  job.cones = FLAGS_iv;
  job.angle_sums = FLAGS_angle_sums;
  job.cut = FLAGS_ie;
  job.con = FLAGS_oc;
  job.fill_holes = FLAGS_fill_holes;
  job.certificate = FLAGS_certificate;
  job.options = {FLAGS_triangulation, FLAGS_angle_fit, FLAGS_angle_strategy, FLAGS_strategy,
                 FLAGS_layout,        FLAGS_epsilon,   FLAGS_max_iterations};
  job.domain = {FLAGS_domain,        FLAGS_centre,  FLAGS_angle_zero, FLAGS_pole,
                FLAGS_normalization, FLAGS_corners, FLAGS_sides};
  return job;
}

Status CheckArguments(const std::vector<std::string>& others) {
  if (!others.empty()) {
    return Status::InvalidInput("unexpected argument '" + others.front() + "'; see --help");
  }
  if (FLAGS_io.empty() == FLAGS_ic.empty()) {
    return Status::InvalidInput(FLAGS_io.empty() ? "-io IN is missing; see --help"
                                                 : "give one of -io and -ic");
  }
  if (FLAGS_no && FLAGS_ic.empty()) {
    return Status::InvalidInput("-no lays out a flat metric: name it with -ic");
  }
  if (FLAGS_oo.empty() && (FLAGS_ic.empty() || FLAGS_oc.empty())) {
    return Status::InvalidInput("-oo OUT is missing; see --help");
  }
  return CheckDomainFlags(JobOfFlags());
}

/// The thesis's other way to call the program: all options in one text file.
StatusOr<std::vector<std::string>> ParseOptionsFile(const std::string& path) {
  std::ifstream file(path);
  if (!file) return Status::InvalidInput(path + ": cannot read this file of options; see --help");
  std::vector<std::string> words = {"circle_patterns"};
  for (std::string word; file >> word;) words.push_back(word);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  const auto others = ParseFlags(static_cast<int>(arguments.size()), arguments.data(), kSource);
  return others.ok() ? others : others.status().In(path);
}

int Main(int argc, char** argv) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_ERROR;  // Ceres warns of what the summaries say
  google::InitGoogleLogging(argv[0]);
  UseOneBlasThread();
  StatusOr<std::vector<std::string>> others = ParseFlags(argc, argv, kSource);
  if (others.ok() && argc == 2 && others->size() == 1) others = ParseOptionsFile(others->front());
  if (!others.ok()) return Conclude(others.status());
  if (FLAGS_help) {
    std::cout << kUsage << "\n"
              << FlagHelp(kSource) << "\nangle fits: " << Join(AngleObjectives().Names())
              << "\nsolvers:    " << Join(SolverStrategies().Names()) << "\n";
    return 0;
  }
  if (Status s = CheckArguments(*others); !s.ok()) return Conclude(s);
  const CirclePatternsJob job = JobOfFlags();
  CatchInterrupts();
  SolveProgress progress(stderr);
  const SolveControl control{progress.Callback(), InterruptFlag()};
  const Status status = job.input_con.empty() ? RunCirclePatterns(job, control, std::cout)
                                              : RunOnMetric(job, control, std::cout);
  progress.Erase();
  return Conclude(status);
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::Main(argc, argv); }
