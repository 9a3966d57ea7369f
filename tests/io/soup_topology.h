#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cirque/io/polygon_soup.h"

namespace cirque {

/// What a plain count over a triangle soup finds, without any halfedge structure.
struct SoupTopology {
  std::string defect;  ///< the first violation of manifoldness, orientation or connectedness
  Index vertices = 0, edges = 0, faces = 0;
  Index loops = 0, boundary_edges = 0, components = 0;
  std::map<std::pair<Index, Index>, Index> opposite;  ///< directed edge -> third corner
  std::vector<Index> valence;
  std::vector<bool> on_boundary;

  Index EulerCharacteristic() const { return vertices - edges + faces; }
};

SoupTopology MeasureTopology(const PolygonSoup& soup);

/// The smallest corner angle [rad].
double SmallestAngle(const PolygonSoup& soup);

}  // namespace cirque
