#pragma once

#include <vector>

#include "cirque/verify/angle_targets.h"
#include "cirque/verify/uv_complex.h"

namespace cirque::verify {

/// A vertex inside the mesh, on a seam, whose UV angles do not sum to 2 pi.
struct Cone {
  Index vertex = kNone;
  double angle_sum = 0;  ///< radians
};

/// Corner angles of the UV triangles, in radians.
struct AngleMeasures {
  double smallest_angle = kUnknown;
  double delaunay_margin = kUnknown;   ///< min over inner edges of pi - the two opposite angles
  Index num_plain = 0;                 ///< vertices inside the mesh and on no seam
  double largest_plain_deviation = 0;  ///< of their angle sums from 2 pi
  std::vector<Index> wrapped;          ///< those round which the triangles turn not exactly once
  Index num_on_seam = 0;               ///< vertices inside the mesh and on a seam
  std::vector<Cone> cones;             ///< those off 2 pi by more than the tolerance
  double largest_flat_seam_deviation = 0;  ///< of the angle sums from 2 pi at the others of them
  std::vector<Index> off_target;           ///< vertices off their target by more than the tolerance
  double largest_target_deviation = kUnknown;
};

/// Whether a plain vertex is wrapped is decided exactly, from comparisons of coordinates alone, and
/// means something only where no triangle is flipped.
AngleMeasures MeasureAngles(const UvComplex& complex, const AngleTargets& targets,
                            double tolerance);

}  // namespace cirque::verify
