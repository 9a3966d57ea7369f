#pragma once

#include <array>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/grouping.h"
#include "cirque/core/types.h"
#include "cirque/lattice/flat_domain.h"
#include "cirque/layout/exact_map.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// The way from faces of a triangulation that a surface was flipped to back to the surface, by the
/// pieces of an exact map, which lie in one face of either.
class SolvedPieces {
 public:
  /// `solved` has the surface's vertices; all three must outlive this.
  SolvedPieces(const Surface& surface, const FlatDomain& solved, const ExactMap& map);

  /// The point of the surface at barycentric coordinates in a face of the other triangulation.
  SurfacePoint OnSurface(Index face, const Eigen::Vector3d& barycentric) const;

  /// F: the area on the surface of every face of the other triangulation.
  Eigen::VectorXd SurfaceAreas() const;

 private:
  using Coordinates = std::array<Eigen::Vector3d, 3>;  ///< barycentric, of a piece's corners
  using PlacedVertex = std::pair<Index, Eigen::Vector2d>;

  /// The corners of a face of the other triangulation, counter-clockwise, in the map's plane.
  std::vector<PlacedVertex> VerticesIn(Index face) const;
  /// The same in the order of the face's corners.
  std::array<Eigen::Vector2d, 3> Corners(Index face) const;
  Coordinates OnInput(Index piece) const;

  const Surface& surface_;
  const FlatDomain& solved_;
  const ExactMap& map_;
  Buckets pieces_;                      ///< by faces of the other triangulation
  std::vector<Coordinates> in_solved_;  ///< of every piece
};

/// Where a point of a surface is in space.
Eigen::Vector3d PositionOf(const Surface& surface, const SurfacePoint& point);

}  // namespace cirque
