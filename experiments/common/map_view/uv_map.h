#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/math/unit_lattice.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// A map to look at: the surface, of one component or several, and its image in the plane or on the
/// sphere.
struct UvMap {
  Surface surface;
  CornerUv uv;  ///< in the plane; of a map to the sphere each face's chords in a plane of their own

  /// The points of the image: a vertex has one for every different uv of its corners.
  std::vector<Index> point;                ///< 3F: of each corner
  std::vector<Index> point_vertex;         ///< the vertex of each point
  std::vector<Eigen::Vector2d> point_uv;   ///< its place; empty: on the sphere
  std::vector<Eigen::Vector3d> on_sphere;  ///< the place of each point there; empty: in the plane
  std::vector<Index> seams;                ///< halfedges, both sides: interior, their uvs differ
  std::vector<Index> boundary;             ///< halfedges on the surface's boundary
  /// Interior vertices whose seams match, angle sum in the image [rad].
  std::vector<std::pair<Index, double>> cones;

  /// What the image repeats by: its seams take this lattice to itself; none: they need not.
  std::optional<LatticeKind> lattice;

  bool IsOnSphere() const { return !on_sphere.empty(); }
};

/// Finds seams and cones. UVs of one vertex are the same point where they are equal, bit for bit.
UvMap MakeUvMap(Surface surface, CornerUv uv);

/// Of a map to the unit sphere, by the places of the vertices.
UvMap MakeSphereMap(Surface surface, const std::vector<Eigen::Vector3d>& position);

/// Reads a mesh with texture coordinates. Error: no such file, no uv at a corner.
StatusOr<UvMap> ReadUvMap(const std::string& path);

}  // namespace cirque
