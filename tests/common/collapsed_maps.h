#pragma once

#include <cstddef>

#include "cirque/layout/collapsed_map.h"
#include "cirque/math/predicates.h"
#include "cirque/mesh/coarsen.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// A map of the faces that are left, of their points; the others' corners lie where no triangle
/// could have them.
template <class Map>
CollapsedMap MapOfRest(const Surface& surface, const CoarseSurface& coarse, const Map& map) {
  const std::size_t corners = surface.triangulation.vertex.size();
  CollapsedMap result{coarse.collapses.corner,
                      std::vector<bool>(corners / 3, false),
                      std::vector<bool>(corners, false),
                      {}};
  result.uv.value.assign(corners, {1e9, -1e9});
  for (const Index f : coarse.face) {
    result.there[f] = true;
    for (Index k = 0; k < 3; ++k) {
      result.uv.value[3 * f + k] = map(surface.position[result.corner[f][k]]);
    }
  }
  return result;
}

/// How many faces that are there are not counter-clockwise.
inline std::size_t NumFlipped(const CollapsedMap& map) {
  std::size_t flipped = 0;
  for (std::size_t f = 0; f < map.there.size(); ++f) {
    const Eigen::Vector2d* p = &map.uv.value[3 * f];
    flipped += map.there[f] && OrientationSign(p[0], p[1], p[2]) <= 0;
  }
  return flipped;
}

/// Points of the plane turned and shifted far off.
inline Eigen::Vector2d MovedHalf(const Eigen::Vector3d& p) {
  return {0.6 * p.x() - 0.8 * p.y() + 1000, 0.8 * p.x() + 0.6 * p.y() - 70};
}

inline bool IsMoved(const CollapsedMap& map, Index face) {
  return map.uv.value[3 * face].x() > 500;
}

/// The map of what is left of FlatStrip(24, ...), cut between faces on both sides of its middle:
/// those on the right are moved.
inline CollapsedMap TwoHalves(const Surface& plane, const CoarseSurface& coarse) {
  CollapsedMap map = MapOfRest(
      plane, coarse, [](const Eigen::Vector3d& p) { return Eigen::Vector2d(p.x(), p.y()); });
  for (const Index f : coarse.face) {
    double x = 0;
    for (const Index v : map.corner[f]) x += plane.position[v].x() / 3;
    for (Index k = 0; k < 3 && x > 12; ++k) {
      map.uv.value[3 * f + k] = MovedHalf(plane.position[map.corner[f][k]]);
    }
  }
  for (const Index f : coarse.face) {
    for (const Index g : coarse.face) {
      if (IsMoved(map, f) == IsMoved(map, g)) continue;
      for (Index k = 0; k < 3; ++k) {
        for (Index l = 0; l < 3; ++l) {
          const auto &a = map.corner[f], &b = map.corner[g];
          if (a[(k + 1) % 3] == b[(l + 2) % 3] && a[(k + 2) % 3] == b[(l + 1) % 3]) {
            map.cut[3 * f + k] = map.cut[3 * g + l] = true;
          }
        }
      }
    }
  }
  return map;
}

}  // namespace cirque
