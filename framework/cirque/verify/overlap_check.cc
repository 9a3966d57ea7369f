#include "cirque/verify/overlap_check.h"

#include "cirque/math/image_overlap.h"

namespace cirque::verify {

OverlapResult CheckOverlap(const UvComplex& complex) {
  const ImageOverlap found = FindImageOverlap({complex.uv, complex.uv_twin});
  OverlapResult result{
      found.num_boundary_edges, found.num_boundary_loops, {}, found.overlap, found.crosses};
  for (const Index h : found.wrapped) {
    result.wrapped_boundary.push_back(complex.mesh().Origin(complex.mesh().Tail(h)));
  }
  return result;
}

}  // namespace cirque::verify
