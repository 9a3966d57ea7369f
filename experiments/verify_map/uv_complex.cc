#include "experiments/verify_map/uv_complex.h"

#include <utility>

namespace cirque::verify_map {
namespace {

std::vector<Index> GlueEqualUvs(const Surface& surface, const std::vector<Point>& uv) {
  std::vector<Index> glued(uv.size(), kNone);
  for (Index h = 0; h < static_cast<Index>(uv.size()); ++h) {
    const Index t = surface.twin[h];
    if (t == kNone) continue;
    if (uv[h] == uv[FanMesh::Next(t)] && uv[FanMesh::Next(h)] == uv[t]) glued[h] = t;
  }
  return glued;
}

/// Numbers the connected pieces in the order of their first triangles.
void LabelPatches(UvComplex* complex) {
  complex->patch.assign(complex->num_triangles(), kNone);
  std::vector<Index> stack;
  for (Index seed = 0; seed < complex->num_triangles(); ++seed) {
    if (complex->patch[seed] != kNone) continue;
    complex->patch[seed] = complex->num_patches;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index f = stack.back();
      stack.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = complex->uv_twin[h] == kNone ? f : complex->uv_twin[h] / 3;
        if (complex->patch[g] != kNone) continue;
        complex->patch[g] = complex->num_patches;
        stack.push_back(g);
      }
    }
    ++complex->num_patches;
  }
}

}  // namespace

UvComplex BuildUvComplex(Surface surface, std::vector<Point> uv) {
  UvComplex complex;
  complex.uv_twin = GlueEqualUvs(surface, uv);
  complex.surface = std::move(surface);
  complex.uv = std::move(uv);
  LabelPatches(&complex);
  return complex;
}

Orientations ClassifyTriangles(const UvComplex& complex) {
  Orientations result;
  for (Index f = 0; f < complex.num_triangles(); ++f) {
    const int sign = Orientation(complex.uv[3 * f], complex.uv[3 * f + 1], complex.uv[3 * f + 2]);
    if (sign < 0) result.flipped.push_back(f);
    if (sign == 0) result.zero_area.push_back(f);
  }
  return result;
}

}  // namespace cirque::verify_map
