#include "cirque/layout/half_plane.h"

#include <algorithm>
#include <cmath>

namespace cirque {

HalfPlane MoveToHalfPlane(const Triangulation& t, const CornerUv& layout,
                          const std::vector<Index>& chain) {
  HalfPlane result;
  std::vector<Complex>& z = result.position;
  z.resize(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    z[t.vertex[h]] = {layout.value[h].x(), layout.value[h].y()};
  }
  const Complex origin = z[chain.front()], span = z[chain.back()] - origin;
  for (Complex& p : z) p = (p - origin) / span;
  result.increasing = true;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    result.straightness = std::max(result.straightness, std::abs(z[chain[k]].imag()));
    z[chain[k]] = z[chain[k]].real();
    if (k > 0 && !(z[chain[k - 1]].real() < z[chain[k]].real())) result.increasing = false;
  }
  return result;
}

}  // namespace cirque
