#pragma once

#include <string>
#include <vector>

#include "cirque/io/polygon_soup.h"

namespace cirque::testing {

/// A soup of these points and polygons, whose vertices count from 0.
PolygonSoup MakeSoup(std::vector<Eigen::Vector3d> position,
                     const std::vector<std::vector<Index>>& polygons);

/// Regular, edges of length sqrt(8), outward oriented.
PolygonSoup Tetrahedron();

/// A 3 x 3 grid of quadrilaterals whose opposite sides are joined.
PolygonSoup Torus();

/// `n` quadrilaterals in a ring; one-sided when `twisted`, else an annulus.
PolygonSoup Ring(Index n, bool twisted);

/// One triangle, its vertices in the plane z = 0.
PolygonSoup OneTriangle();

/// A file name for this process alone.
std::string TempPath(const std::string& name);

}  // namespace cirque::testing
