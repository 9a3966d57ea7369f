#include "cirque/layout/latlong.h"

#include <array>
#include <cmath>

namespace cirque {
namespace {

using Eigen::Vector3d;

bool IsAtPole(const Vector3d& x) { return x.x() == 0 && x.y() == 0; }

double Latitude(const Vector3d& x) { return std::atan2(x.z(), std::hypot(x.x(), x.y())); }

/// The difference of two longitudes in turns, in [-1/2, 1/2].
double ShortWay(double from, double to) { return std::remainder(to - from, 1.0); }

/// The u of three corners, each reached from the one before by the short way. Returns false when
/// they do not come back: the triangle goes around a pole.
bool Unroll(const std::array<Vector3d, 3>& corner, std::array<double, 3>* u) {
  int first = 0;
  while (first < 2 && IsAtPole(corner[first])) ++first;
  std::array<double, 3> turns;
  for (int k = 0; k < 3; ++k) {
    turns[k] = std::atan2(corner[k].y(), corner[k].x()) / (2 * kPi) + 0.5;
  }
  (*u)[first] = turns[first];
  int last = first;
  double sum = turns[first];
  int count = 1;
  for (const int step : {1, 2}) {
    const int k = (first + step) % 3;
    if (IsAtPole(corner[k])) continue;
    (*u)[k] = (*u)[last] + ShortWay(turns[last], turns[k]);
    last = k;
    sum += (*u)[k];
    ++count;
  }
  for (int k = 0; k < 3; ++k) {
    if (IsAtPole(corner[k])) (*u)[k] = sum / count;
  }
  if (count < 3) return true;
  const double back = (*u)[last] + ShortWay(turns[last], turns[first]);
  return std::abs(back - (*u)[first]) < 0.5;
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
