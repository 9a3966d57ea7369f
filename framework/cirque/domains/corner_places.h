#pragma once

#include <complex>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Where a layout without seams has the vertices.
std::vector<std::complex<double>> PlacesOfVertices(const Triangulation& triangulation,
                                                   const CornerUv& uv);

/// Measures a map as it lies. Refuses one that comes out flipped with kUnrepresentable, `because`, but
/// beside an exact one.
Status MeasurePlaced(const Surface& surface, const char* because, SurfaceMap* map);

/// Puts the corners of a map there, then MeasurePlaced.
Status PutCorners(const Surface& surface, const std::vector<std::complex<double>>& place,
                  const char* because, SurfaceMap* map);

/// Takes away a proof that is about a surface other than the map's.
void ForgetProof(SurfaceMap* map);

/// Takes the cut away from a map of which every vertex has one place.
void ForgetCut(const Triangulation& triangulation, SurfaceMap* map);

}  // namespace cirque
