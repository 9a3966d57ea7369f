#pragma once

#include <vector>

#include <Eigen/Core>

#include "experiments/verify_map/angle_check.h"
#include "experiments/verify_map/uv_complex.h"

namespace cirque::verify_map {

/// How far the map is from a conformal and from an area-preserving one. Triangles without area on
/// the surface or in the plane have no distortion and are only counted. Means, percentiles and the
/// L2 norm weigh triangles by their area on the surface.
struct Distortion {
  Index num_skipped = 0;
  double quasi_conformal_mean = kUnknown;  ///< ratio of the larger to the smaller singular value
  double quasi_conformal_p50 = kUnknown;
  double quasi_conformal_p95 = kUnknown;
  double quasi_conformal_p99 = kUnknown;
  double quasi_conformal_max = kUnknown;
  Index quasi_conformal_worst = kNone;  ///< the triangle of the maximum
  double log_area_min = kUnknown;       ///< of log(area in the plane / area on the surface), both
  double log_area_max = kUnknown;       ///< as fractions of the whole
  double log_area_l2 = kUnknown;        ///< root of the weighted mean square
};
Distortion MeasureDistortion(const UvComplex& complex,
                             const std::vector<Eigen::Vector3d>& position);

/// How well the two sides of the seams agree.
struct SeamAgreement {
  Index num_edges = 0;
  double largest_difference = kUnknown;  ///< relative, of the two lengths of one edge
  Index worst_halfedge = kNone;
};
/// Two sides in one patch must have one length; sides in two patches one ratio, the same (the
/// median) along all that the two patches have in common, since each patch may have its own scale.
SeamAgreement CompareSeams(const UvComplex& complex);

}  // namespace cirque::verify_map
