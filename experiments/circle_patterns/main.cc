// The thesis's program: a triangle mesh in, its conformal map out.
#include <fstream>
#include <iostream>
#include <map>

#include <fmt/format.h>
#include <gflags/gflags.h>
#include <glog/logging.h>

#include "cirque/cones/registry.h"
#include "cirque/core/parallel.h"
#include "cirque/core/text.h"
#include "cirque/domains/registry.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/layout/map_objective.h"
#include "cirque/linear/multigrid.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/circle_patterns/domains.h"
#include "experiments/circle_patterns/run.h"
#include "experiments/common/blas_threads.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/common/heap.h"
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
DEFINE_string(
    cut_paths, "",
    "'a-b,c-d': open shortest paths between these vertices, counted from 1, instead of -ie");
DEFINE_bool(flip_back, false, "-oc after undoing every flip that the flat metric allows");
DEFINE_bool(fill_holes, false,
            "close all boundary loops but the longest for the solve; the fill is not written");
DEFINE_string(triangulation, cirque::ParameterizeOptions().triangulation,
              "delaunay: intrinsic Delaunay flips first; input: the file's connectivity");
DEFINE_string(layout, cirque::ParameterizeOptions().layout, "directions or least_squares");
DEFINE_string(certificate, "", "file for the certificate; empty: OUTPUT.certificate.json");
DEFINE_string(measures, "",
              "files of distortion measures, a comma between: .csv (per face), .json (per map), "
              ".ply or .ply:METRIC (colours)");
DEFINE_string(angle_objective, "",
              "objective of the angle fit; default: quadratic, for the sphere entropy");
DEFINE_string(angle_solver, cirque::ParameterizeOptions().angle_solver, "solver of the angle fit");
DEFINE_string(radii_solver, cirque::ParameterizeOptions().radii_solver, "solver of the log radii");
DEFINE_string(cones, cirque::ParameterizeOptions().cones,
              "cone heuristic, NAME or NAME:KEY=VALUE,...; without it a closed surface gets "
              "cones that stretch its triangles little, a torus none");
DEFINE_int32(cone_budget, cirque::ParameterizeOptions().cone_budget,
             "the most cones; -1: as the heuristic has it");
DEFINE_string(cone_angles, cirque::ParameterizeOptions().cone_angles,
              "free, pi/2, pi/3 (multiples of that), ranges or ranges:width=RADIANS");
DEFINE_string(refine_map, cirque::ParameterizeOptions().refine_map,
              "NAME or NAME:KEY=VALUE,...: moves the finished map to less distortion, cones and "
              "seams kept; a refinement below");
DEFINE_string(seams, cirque::ParameterizeOptions().seams,
              "rigid: the two sides of a cut stay congruent; free: cones only choose the cut");
DEFINE_int32(refine_cones, cirque::ParameterizeOptions().refine_cones,
             "steps that lower the realised area distortion by the cones' angles");
DEFINE_string(cut_cost, cirque::ParameterizeOptions().cut_cost,
              "what the cut is short in: flat_length, length, distortion or curvature");
DEFINE_string(edge_costs, cirque::ParameterizeOptions().edge_costs,
              "file of factors on that: 'from to cost' a line");
DEFINE_double(epsilon, cirque::ParameterizeOptions().epsilon,
              "least corner and intersection angle in radians; shrinks where it must");
DEFINE_int32(max_iterations, cirque::ParameterizeOptions().max_iterations, "steps of each solve");
DEFINE_int32(threads, 0,
             "most threads of loops over faces and edges; 0: as CIRQUE_NUM_THREADS says,\n"
             "else all cores");
DEFINE_string(domain, "plane",
              "shape to map onto: plane, sphere, disk, half_plane, rectangle, polygon, triangle");
DEFINE_string(
    pole, "",
    "sphere, disk, half_plane: vertex that the solve sends to infinity; like all vertices\n"
    "given here counted from 1; default: chosen");
DEFINE_string(
    normalization, "",
    "sphere: none, uniform, surface_area, image_area or least_area_distortion; disk: none,\n"
    "boundary or area: instead of a vertex, a centre of mass goes to 0");
DEFINE_bool(principal_axes, false, "sphere: turned to the principal axes of the surface's area");
DEFINE_bool(inversion, true,
            "sphere: fit angles to the surface inverted about the pole, not to its own");
DEFINE_string(latlong, "", "sphere: output .obj with latitude and longitude as texture");
DEFINE_string(centre, "", "disk: inner vertex that goes to 0");
DEFINE_string(angle_zero, "", "disk: boundary vertex that goes to (1, 0)");
DEFINE_string(corners, "", "rectangle, polygon, triangle: boundary vertices with commas");
DEFINE_int32(sides, 0, "polygon: how many corners to choose, where none are given (4)");
DECLARE_bool(help);

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/circle_patterns/";
const std::map<std::string, std::string> kFormerFlags = {{"angle_fit", "angle_objective"},
                                                         {"angle_strategy", "angle_solver"},
                                                         {"strategy", "radii_solver"}};
constexpr char kUsage[] =
    "Maps a triangle mesh conformally by a circle pattern.\n"
    "  circle_patterns -io IN.obj -oo OUT.obj\n"
    "  circle_patterns -ic IN.con -oo OUT.obj\n"
    "  circle_patterns -domain=sphere -io IN.obj -oo OUT.obj (or OUT.ply)\n"
    "  circle_patterns OPTIONS.txt           all options in one text file\n"
    "  mpirun -n 4 circle_patterns ...       -radii_solver=newton_amg distributed over processes\n"
    "Exit status: 0 done, 1 not converged, 2 bad input, 3 proven infeasible, 4 unrepresentable.\n";

int Conclude(const Status& status) {
  if (!status.ok()) std::cerr << "circle_patterns: " << status.message() << "\n";
  return ExitStatus(status.code());
}

Status CheckArguments(const std::vector<std::string>& others) {
  if (!others.empty()) {
    return Status::InvalidInput("unexpected argument '" + others.front() + "'; see --help");
  }
  if (FLAGS_io.empty() == FLAGS_ic.empty()) {
    return Status::InvalidInput(FLAGS_io.empty() ? "-io IN is missing; see --help"
                                                 : "give one of -io and -ic");
  }
  if (!FLAGS_cones.empty() && !(FLAGS_iv.empty() && FLAGS_angle_sums.empty())) {
    return Status::InvalidInput(
        "give the cones by -cones or by a file (-iv, -angle_sums), not both");
  }
  if (FLAGS_no && FLAGS_ic.empty()) {
    return Status::InvalidInput("-no lays out a flat metric: name it with -ic");
  }
  const ParameterizeOptions plain;
  if (FLAGS_no && (FLAGS_refine_map != plain.refine_map || FLAGS_seams != plain.seams)) {
    return Status::InvalidInput(
        "-no lays out the metric as it is: leave out -refine_map and -seams");
  }
  if (!FLAGS_ie.empty() && !FLAGS_cut_paths.empty()) {
    return Status::InvalidInput("give one of -ie and -cut_paths");
  }
  if (FLAGS_threads < 0) return Status::InvalidInput("-threads must be 0 or more");
  if (FLAGS_flip_back && FLAGS_oc.empty()) {
    return Status::InvalidInput("-flip_back is about the metric of -oc, which is missing");
  }
  if (FLAGS_oo.empty() && (FLAGS_ic.empty() || FLAGS_oc.empty())) {
    return Status::InvalidInput("-oo OUT is missing; see --help");
  }
  return CheckDomainFlags(FLAGS_domain);
}

Status Run(const CirclePatternsJob& job, const SolveControl& control) {
  return job.input_con.empty() ? RunCirclePatterns(job, control, std::cout)
                               : RunOnMetric(job, control, std::cout);
}

StatusOr<CirclePatternsJob> JobOfFlags() {
  CirclePatternsJob job;
  StatusOr<std::vector<MeasureFile>> measures = ParseMeasureFiles(FLAGS_measures);
  if (!measures.ok()) return measures.status().In("--measures");
  job.measures = *std::move(measures);
  job.input = FLAGS_io;
  job.output = FLAGS_oo;
  job.input_con = FLAGS_ic;
  job.layout_only = FLAGS_no;
  job.cones = FLAGS_iv;
  job.angle_sums = FLAGS_angle_sums;
  job.cut = FLAGS_ie;
  job.cut_paths = FLAGS_cut_paths;
  job.con = FLAGS_oc;
  job.flip_back = FLAGS_flip_back;
  job.fill_holes = FLAGS_fill_holes;
  job.certificate = FLAGS_certificate;
  const ParameterizeOptions defaults = Domains().Find(FLAGS_domain)->recommended;
  job.options = {.triangulation = FLAGS_triangulation,
                 .angle_objective = FLAGS_angle_objective.empty() ? defaults.angle_objective
                                                                  : FLAGS_angle_objective,
                 .angle_solver = FLAGS_angle_solver,
                 .radii_solver = FLAGS_radii_solver,
                 .layout = FLAGS_layout,
                 .cones = FLAGS_cones,
                 .cone_budget = FLAGS_cone_budget,
                 .cone_angles = FLAGS_cone_angles,
                 .refine_cones = FLAGS_refine_cones,
                 .refine_map = FLAGS_refine_map,
                 .seams = FLAGS_seams,
                 .cut_cost = FLAGS_cut_cost,
                 .edge_costs = FLAGS_edge_costs,
                 .epsilon = FLAGS_epsilon,
                 .max_iterations = FLAGS_max_iterations};
  job.domain = {FLAGS_domain, FLAGS_centre,         FLAGS_angle_zero,
                FLAGS_pole,   FLAGS_normalization,  FLAGS_corners,
                FLAGS_sides,  FLAGS_principal_axes, FLAGS_inversion};
  job.latlong = FLAGS_latlong;
  return job;
}

/// The thesis's other way to call the program: all options in one text file.
StatusOr<std::vector<std::string>> ParseOptionsFile(const std::string& path) {
  std::ifstream file(path);
  if (!file) return Status::InvalidInput(path + ": cannot read this file of options; see --help");
  std::vector<std::string> words = {"circle_patterns"};
  for (std::string word; file >> word;) words.push_back(word);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  const auto others =
      ParseFlags(static_cast<int>(arguments.size()), arguments.data(), kSource, {}, kFormerFlags);
  return others.ok() ? others : others.status().In(path);
}

int Main(int argc, char** argv) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_ERROR;  // Ceres warns of what the summaries say
  google::InitGoogleLogging(argv[0]);
  UseOneBlasThread();
  UseOneHeap();
  const StatusOr<bool> served = ServeOtherRanks();
  if (!served.ok()) return Conclude(served.status());
  if (*served) return 0;
  StatusOr<std::vector<std::string>> others = ParseFlags(argc, argv, kSource, {}, kFormerFlags);
  if (others.ok() && argc == 2 && others->size() == 1) others = ParseOptionsFile(others->front());
  if (!others.ok()) return Conclude(others.status());
  if (FLAGS_help) {
    std::cout << kUsage << "\n"
              << FlagHelp(kSource) << "\nangle objectives: " << Join(AngleObjectives().Names())
              << "\nsolvers:    " << Join(SolverStrategies().Names())
              << "\ncones:      " << Join(ConeHeuristics().Names())
              << "\nrefinements: " << Join(MapObjectives().Names()) << "\n";
    return 0;
  }
  if (Status s = CheckArguments(*others); !s.ok()) return Conclude(s);
  const StatusOr<CirclePatternsJob> job = JobOfFlags();
  if (!job.ok()) return Conclude(job.status());
  const ThreadLimit limit(FLAGS_threads > 0 ? FLAGS_threads : ThreadsByEnvironment());
  CatchInterrupts();
  SolveProgress progress(stderr);
  const SolveControl control{progress.Callback(), InterruptFlag()};
  const Status status = Run(*job, control);
  progress.Erase();
  return Conclude(status);
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::Main(argc, argv); }
