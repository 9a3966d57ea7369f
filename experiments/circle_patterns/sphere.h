#pragma once

#include <ostream>
#include <string>

#include "cirque/domains/sphere.h"

#include "experiments/circle_patterns/run.h"

namespace cirque {

/// What the program was asked to do with --domain=sphere, beside CirclePatternsJob and its domain.
struct SphereJob {
  bool principal_axes = false;
  bool inversion = true;  ///< SphereOptions
  std::string latlong;    ///< .obj to write with latitude and longitude as texture; empty: none
};

/// Maps the closed mesh job.input to the sphere. The output is an OBJ of its triangles with their
/// points on the sphere, or a PLY with the points as they were, those on the sphere as properties
/// sx, sy, sz, and the distortion of every face. Vertices of no face are at (0, 0, 0) on the
/// sphere. Files are written as by RunCirclePatterns.
Status RunSphere(const CirclePatternsJob& job, const SphereJob& sphere, const SolveControl& control,
                 std::ostream& report);

}  // namespace cirque
