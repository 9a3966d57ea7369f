#pragma once

#include <atomic>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/sphere_normalization.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"

namespace cirque {

/// Draws the exact map of a closed surface that was solved on another triangulation, whose vertices a
/// layout has in the plane: normalised and refined on that triangulation by itself, each of its faces
/// drawn as the radial image of the straight triangle between where its corners go, so that each face
/// of the overlay is part of a face that is not flipped. Fills in the map's exact_map and the
/// certificate's. Errors: kUnrepresentable for a flipped face; those of NormalizeChart and
/// DrawExactMap; kInvalidInput for an overlay above the limit; cancelled.
Status MakeExactOnSphere(const Surface& surface, const IntrinsicTriangulation& solved,
                         const DomainOptions& shape, const ParameterizeOptions& options,
                         const PlaneWithPole& plane, const std::atomic<bool>* cancelled,
                         SurfaceMap* map);

/// Where an exact map to the sphere has the first so many points, which are the surface's vertices.
std::vector<Eigen::Vector3d> PlacesOfVertices(const ExactMap& map, Index num_vertices);

}  // namespace cirque
