#pragma once

#include "experiments/verify_map/angle_check.h"
#include "experiments/verify_map/uv_complex.h"

namespace cirque::verify_map {

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
