#include "cirque/metrics/spherical.h"

#include <cmath>

#include <Eigen/Geometry>

#include "cirque/intrinsic/corner_angles.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/math/predicates.h"

namespace cirque {

using Eigen::Vector3d;

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

EdgeLengths ChordLengths(const Triangulation& t, const std::vector<Vector3d>& position) {
  EdgeLengths lengths;
  lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    lengths.value[e] = (position[t.Tip(h)] - position[t.Tail(h)]).norm();
  }
  return lengths;
}

CornerUv FacesInPlane(const Triangulation& t, const EdgeLengths& lengths) {
  const CornerAngles angles = MeasureCornerAngles(t, lengths);
  CornerUv uv;
  uv.value.resize(t.num_halfedges());
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const double base = lengths.value[t.edge[h + 2]], side = lengths.value[t.edge[h + 1]];
    uv.value[h] = {0, 0};
    uv.value[h + 1] = {base, 0};
    uv.value[h + 2] = {side * std::cos(angles.value[h]), side * std::sin(angles.value[h])};
  }
  return uv;
}

Eigen::VectorXd AngleDifferences(const Triangulation& t, const EdgeLengths& from,
                                 const EdgeLengths& to) {
  return (MeasureCornerAngles(t, from).value - MeasureCornerAngles(t, to).value).cwiseAbs();
}

}  // namespace cirque
