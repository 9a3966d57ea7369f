#include "cirque/verify/correspondence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>

namespace cirque::verify {
namespace {

using Corners = std::array<Index, 3>;

Corners CornersOf(const FanMesh& mesh, Index f) {
  return {mesh.vertex[3 * f], mesh.vertex[3 * f + 1], mesh.vertex[3 * f + 2]};
}

Corners Sorted(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

bool SameCycle(const Corners& a, Corners b) {
  for (int turn = 0; turn < 3; ++turn) {
    if (a == b) return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return false;
}

struct KeyedTriangle {
  Corners key;
  Index triangle;

  bool operator<(const KeyedTriangle& other) const {
    return key != other.key ? key < other.key : triangle < other.triangle;
  }
};

std::vector<KeyedTriangle> SortedTriangles(const FanMesh& mesh) {
  std::vector<KeyedTriangle> sorted(mesh.num_triangles());
  for (Index f = 0; f < mesh.num_triangles(); ++f) sorted[f] = {Sorted(CornersOf(mesh, f)), f};
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

bool ListedInOrder(const FanMesh& in, const FanMesh& out) {
  if (in.num_triangles() != out.num_triangles()) return false;
  for (Index f = 0; f < in.num_triangles(); ++f) {
    if (Sorted(CornersOf(in, f)) != Sorted(CornersOf(out, f))) return false;
  }
  return true;
}

void MatchAsSets(const FanMesh& in, const FanMesh& out, Correspondence* result) {
  const std::vector<KeyedTriangle> a = SortedTriangles(in), b = SortedTriangles(out);
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (j == b.size() || (i < a.size() && a[i].key < b[j].key)) {
      result->missing.push_back(a[i++].triangle);
    } else if (i == a.size() || b[j].key < a[i].key) {
      result->extra.push_back(b[j++].triangle);
    } else {
      result->out_triangle[a[i++].triangle] = b[j++].triangle;
    }
  }
  std::sort(result->missing.begin(), result->missing.end());
  std::sort(result->extra.begin(), result->extra.end());
}

}  // namespace

Correspondence MatchTriangles(const FanMesh& in, const FanMesh& out) {
  Correspondence result;
  result.out_triangle.assign(in.num_triangles(), kNone);
  result.same_order = ListedInOrder(in, out);
  if (result.same_order) {
    std::iota(result.out_triangle.begin(), result.out_triangle.end(), 0);
  } else {
    MatchAsSets(in, out, &result);
  }
  for (Index f = 0; f < in.num_triangles(); ++f) {
    const Index g = result.out_triangle[f];
    if (g != kNone && !SameCycle(CornersOf(in, f), CornersOf(out, g))) result.reversed.push_back(f);
  }
  return result;
}

FanMesh Reorder(const FanMesh& out, const Correspondence& correspondence) {
  FanMesh mesh;
  mesh.num_vertices = out.num_vertices;
  mesh.vertex.reserve(out.vertex.size());
  mesh.soup_corner.reserve(out.vertex.size());
  for (const Index f : correspondence.out_triangle) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      mesh.vertex.push_back(out.vertex[h]);
      mesh.soup_corner.push_back(out.soup_corner[h]);
    }
  }
  return mesh;
}

Displacement ComparePositions(const std::vector<Eigen::Vector3d>& in,
                              const std::vector<Eigen::Vector3d>& out, double tolerance) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : in) box.extend(p);
  const double extent = box.isEmpty() ? 0.0 : box.diagonal().norm();
  const double diagonal = extent > 0 ? extent : 1.0;
  Displacement result;
  for (std::size_t v = 0; v < in.size(); ++v) {
    const double distance = (in[v] - out[v]).norm();
    const double relative = std::isfinite(distance) ? distance / diagonal : kInfinity;
    if (relative > tolerance) result.moved.push_back(static_cast<Index>(v));
    result.largest = std::max(result.largest, relative);
  }
  return result;
}

}  // namespace cirque::verify
