#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/generators/planar_delaunay.h"

namespace cirque {

/// The Delaunay triangulation of the flat torus of the given periods: of points in the cell
/// [-period / 2, period / 2]^2 and all their translates, one triangle of each class. Needs points
/// spread over the whole cell, so densely that every circumradius is below a few mean distances of
/// points and no triangle meets a translate of itself; a few hundred even ones will do.
std::vector<Triangle> PeriodicDelaunay(const std::vector<Eigen::Vector2d>& points,
                                       const Eigen::Vector2d& periods);

}  // namespace cirque
