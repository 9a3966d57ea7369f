#include "cirque/layout/latlong.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cirque {
namespace {

using Eigen::Vector3d;

bool IsAtPole(const Vector3d& x) { return x.x() == 0 && x.y() == 0; }

double Latitude(const Vector3d& x) { return std::atan2(x.z(), std::hypot(x.x(), x.y())); }

/// The whole number that brings `turns` within 1/2 of `near`.
double WholeTurns(double turns, double near) { return std::nearbyint(near - turns); }

/// The u of three corners, each reached from the one before by the short way: the fraction of its
/// vertex, the same in all triangles, and a whole number. Returns false when they do not come back:
/// the triangle goes around a pole.
bool Unroll(const std::array<Vector3d, 3>& corner, std::array<double, 3>* u) {
  std::array<double, 3> turns, whole = {};
  std::vector<int> proper;
  for (int k = 0; k < 3; ++k) {
    turns[k] = std::atan2(corner[k].y(), corner[k].x()) / (2 * kPi) + 0.5;
    if (!IsAtPole(corner[k])) proper.push_back(k);
  }
  double least = 1;
  for (std::size_t i = 0; i < proper.size(); ++i) {
    const int k = proper[i], before = proper[i == 0 ? 0 : i - 1];
    whole[k] = WholeTurns(turns[k], turns[before] + whole[before]);
    least = std::min(least, turns[k] + whole[k]);
  }
  double mean = 0;
  for (const int k : proper) {
    (*u)[k] = turns[k] + (whole[k] - std::floor(least));
    mean += (*u)[k] / static_cast<double>(proper.size());
  }
  for (int k = 0; k < 3; ++k) {
    if (IsAtPole(corner[k])) (*u)[k] = mean;
  }
  if (proper.size() < 3) return true;
  return WholeTurns(turns[0], turns[2] + whole[2]) == whole[0];
}

}  // namespace

LatLong LatLongUv(const Triangulation& t, const std::vector<Vector3d>& position) {
  LatLong result;
  result.uv.value.resize(t.num_halfedges());
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const std::array<Vector3d, 3> corner = {position[t.vertex[h]], position[t.vertex[h + 1]],
                                            position[t.vertex[h + 2]]};
    std::array<double, 3> u;
    if (!Unroll(corner, &u)) result.at_poles.push_back(Triangulation::Face(h));
    for (int k = 0; k < 3; ++k) {
      result.uv.value[h + k] = {u[k], Latitude(corner[k]) / kPi + 0.5};
    }
  }
  return result;
}

}  // namespace cirque
