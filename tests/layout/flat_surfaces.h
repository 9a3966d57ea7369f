#pragma once

#include "cirque/core/metric.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// A surface with a flat metric of its own (not always the one of its positions) and its cones.
struct KnownFlatSurface {
  Surface surface;
  EdgeLengths lengths;
  CornerAngles angles;
  std::vector<Index> cones;
};

/// The surface of the cube [0, n]^3 in unit squares: 8 cones of 3 pi/2.
KnownFlatSurface FlatCube(int n);

/// The surface of the regular octahedron, its sides in n parts: 6 cones of 4 pi/3.
KnownFlatSurface FlatOctahedron(int n);

/// Two rectangles of n by m unit squares, sewn along their boundary: 4 cones of pi.
KnownFlatSurface FlatPillow(int n, int m);

/// A rectangle of n by m unit squares, left and right side glued: an annulus of girth n, height m.
KnownFlatSurface FlatCylinder(int n, int m);

/// The same with top and bottom glued too.
KnownFlatSurface FlatTorus(int n, int m);

/// The vertices whose angle sum is farther than 1e-6 from 2 pi, if interior.
std::vector<Index> MeasuredCones(const Triangulation& triangulation, const CornerAngles& angles);

}  // namespace cirque
