#pragma once

#include <string>
#include <vector>

#include "cirque/verify/uv_complex.h"

namespace cirque::verify {

/// How the boundary of a map lies on the unit circle. With several loops: that of the outermost
/// one, which encloses the largest area.
struct DiskFit {
  Index num_vertices = 0;         ///< of the loop
  double largest_error = 0;       ///< max | |uv| - 1 |
  Index farthest = kNone;         ///< vertex where
  std::vector<Index> off_circle;  ///< vertices with a larger error than allowed
  /// How often the loop, counter-clockwise from each vertex to the next, passes angle 0: once where
  /// the vertices are in order and no two have the same angle.
  int turns = 0;
  std::vector<Index> out_of_order;  ///< vertices less than a half turn behind the one before
};

/// How the other loops of a map lie on circles, each on that through three of its vertices, a third of
/// the loop apart: of a few such circles that which most vertices lie on.
struct HoleFit {
  Index holes = 0;
  double largest_error = 0;       ///< distance of a vertex from its circle, the disk of radius 1
  std::vector<Index> off_circle;  ///< vertices with a larger error than allowed
};

HoleFit FitHoles(const UvComplex& complex, double tolerance);

/// What is wrong: no holes, vertices off their circles.
std::vector<std::string> HoleErrors(const HoleFit& fit, double tolerance);

/// Judges the map of a surface without seams; the order by exact orientation about 0.
DiskFit FitDisk(const UvComplex& complex, double tolerance);

/// What is wrong: off the circle, out of order, not once round; seams.
std::vector<std::string> DiskErrors(const UvComplex& complex, const DiskFit& fit, double tolerance);

}  // namespace cirque::verify
