#include <iostream>

#include <gflags/gflags.h>

#include "experiments/circle_patterns/run.h"
#include "experiments/common/interrupt.h"
#include "experiments/common/solve_progress.h"

DEFINE_string(io, "", "input mesh: .obj, .off, .ply or .stl");
DEFINE_string(oo, "", "output .obj with the texture coordinates of the map");
DEFINE_string(certificate, "", "where to write the certificate (default: beside the output)");
DEFINE_string(angle_fit, cirque::ParameterizeOptions().angle_fit, "objective of the angle fit");
DEFINE_string(angle_strategy, cirque::ParameterizeOptions().angle_strategy,
              "solver of the angle fit");
DEFINE_string(strategy, cirque::ParameterizeOptions().strategy, "solver of the log radii");
DEFINE_double(epsilon, cirque::ParameterizeOptions().epsilon,
              "least corner and intersection angle in radians; shrinks where it must");
DEFINE_int32(max_iterations, cirque::ParameterizeOptions().max_iterations, "steps of each solve");

int main(int argc, char** argv) {
  gflags::SetUsageMessage(
      "flattens a triangle mesh conformally by a circle pattern\n"
      "  circle_patterns -io IN.obj -oo OUT.obj");
  gflags::ParseCommandLineFlags(&argc, &argv, true);
  const cirque::CirclePatternsJob job = {
      FLAGS_io,
      FLAGS_oo,
      FLAGS_certificate,
      {FLAGS_angle_fit, FLAGS_angle_strategy, FLAGS_strategy, FLAGS_epsilon, FLAGS_max_iterations}};
  cirque::CatchInterrupts();
  cirque::SolveProgress progress(stderr);
  const cirque::SolveControl control{progress.Callback(), cirque::InterruptFlag()};
  const cirque::Status status = cirque::RunCirclePatterns(job, control, std::cout);
  progress.Erase();
  if (!status.ok()) std::cerr << "circle_patterns: " << status.message() << "\n";
  return cirque::ExitStatus(status.code());
}
