#include "cirque/metrics/injectivity.h"

#include <cmath>

#include <Eigen/Geometry>

#include "cirque/math/compensated_sum.h"
#include "cirque/math/image_overlap.h"
#include "cirque/math/predicates.h"

namespace cirque {

using Eigen::Vector3d;

std::vector<Index> FlippedFaces(const Triangulation& t, const CornerUv& uv) {
  std::vector<Index> flipped;
  for (Index f = 0; f < t.num_faces(); ++f) {
    const Eigen::Vector2d &a = uv.value[3 * f], &b = uv.value[3 * f + 1], &c = uv.value[3 * f + 2];
    const bool finite = a.allFinite() && b.allFinite() && c.allFinite();
    if (!finite || OrientationSign(a, b, c) <= 0) flipped.push_back(f);
  }
  return flipped;
}

std::vector<Index> FlippedFacesInFloat32(const Triangulation& t, const CornerUv& uv) {
  CornerUv rounded = uv;
  for (Eigen::Vector2d& x : rounded.value) x = x.cast<float>().cast<double>();
  return FlippedFaces(t, rounded);
}

std::vector<Index> WoundVertices(const Triangulation& t, const CornerUv& uv) {
  // Of triangles that turn once round a vertex one goes from below to above it on the right.
  std::vector<Index> turns(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const double from = uv.value[Triangulation::Next(h)].y(), at = uv.value[h].y();
    if (from < at && uv.value[Triangulation::Prev(h)].y() >= at) ++turns[t.vertex[h]];
  }
  const std::vector<bool> boundary = BoundaryVertices(t);
  std::vector<Index> wound;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (!boundary[v] && turns[v] > 1) wound.push_back(v);
  }
  return wound;
}

bool OverlapsItself(const Triangulation& t, const CornerUv& uv) {
  std::vector<Index> twin(t.twin.size(), kNone);  // side h from corner h to the next
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.twin[h] != kNone) twin[Triangulation::Next(h)] = Triangulation::Next(t.twin[h]);
  }
  return FindImageOverlap({uv.value, twin}).overlaps();
}

std::vector<Index> FlippedSphericalFaces(const Triangulation& t,
                                         const std::vector<Vector3d>& position) {
  std::vector<Index> flipped;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    // From the origin, which is inside, the triangle must turn clockwise.
    const int sign = OrientationSign3(position[t.vertex[h]], position[t.vertex[h + 1]],
                                      position[t.vertex[h + 2]], Vector3d::Zero());
    if (sign >= 0) flipped.push_back(Triangulation::Face(h));
  }
  return flipped;
}

double SphericalDegree(const Triangulation& t, const std::vector<Vector3d>& position) {
  CompensatedSum area;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const Vector3d &a = position[t.vertex[h]], &b = position[t.vertex[h + 1]],
                   &c = position[t.vertex[h + 2]];
    area += 2 * std::atan2(a.dot((b - a).cross(c - a)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return area.Value() / (4 * kPi);
}

}  // namespace cirque
