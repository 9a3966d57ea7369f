#include "cirque/verify/uv_complex.h"

#include <utility>

namespace cirque::verify {
namespace {

std::vector<Index> GlueEqualUvs(const Surface& surface, const std::vector<Point>& uv) {
  std::vector<Index> glued(uv.size(), kNone);
  for (Index h = 0; h < static_cast<Index>(uv.size()); ++h) {
    const Index t = surface.twin[h];
    if (t == kNone) continue;
    if (uv[h] == uv[TriangleMesh::Next(t)] && uv[TriangleMesh::Next(h)] == uv[t]) glued[h] = t;
  }
  return glued;
}

/// Numbers the pieces that hang together by `twin`, in the order of their first triangles, and says
/// how many there are.
Index LabelPieces(const std::vector<Index>& twin, std::vector<Index>* label) {
  label->assign(twin.size() / 3, kNone);
  Index num_pieces = 0;
  std::vector<Index> stack;
  for (Index seed = 0; seed < static_cast<Index>(label->size()); ++seed) {
    if ((*label)[seed] != kNone) continue;
    (*label)[seed] = num_pieces;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index f = stack.back();
      stack.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = twin[h] == kNone ? f : twin[h] / 3;
        if ((*label)[g] != kNone) continue;
        (*label)[g] = num_pieces;
        stack.push_back(g);
      }
    }
    ++num_pieces;
  }
  return num_pieces;
}

}  // namespace

UvComplex BuildUvComplex(Surface surface, std::vector<Point> uv) {
  UvComplex complex;
  complex.uv_twin = GlueEqualUvs(surface, uv);
  complex.surface = std::move(surface);
  complex.uv = std::move(uv);
  std::vector<Index> component;
  complex.num_components = LabelPieces(complex.surface.twin, &component);
  complex.num_patches = LabelPieces(complex.uv_twin, &complex.patch);
  for (Index h = 0; h < static_cast<Index>(complex.uv.size()); ++h) {
    complex.num_seam_edges += complex.IsSeam(h) && h < complex.surface.twin[h];
  }
  return complex;
}

}  // namespace cirque::verify
