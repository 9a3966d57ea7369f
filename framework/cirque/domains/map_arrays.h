#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/exact_mesh.h"
#include "cirque/domains/map_options.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/certificate.h"

/// One call from arrays to a map, of meshes of one component or several, clean or not: what
/// circle_patterns does to files. All indices count from 0; messages, made for files, name vertices
/// and faces from 1.
namespace cirque {

/// A mesh in arrays of the caller's, which are read where they are.
struct MeshArrays {
  std::span<const double> points;  ///< 3V: x, y and z of every vertex
  std::span<const Index> corners;  ///< the vertices of every polygon's corners, one after the other
  /// P + 1: polygon p owns corners [first_corner[p], first_corner[p + 1]); empty: triangles.
  std::span<const Index> first_corner = {};
};

/// Those of a soup, which must outlive them.
inline MeshArrays ArraysOf(const PolygonSoup& soup) {
  const double* const points = soup.position.empty() ? nullptr : soup.position.front().data();
  return {{points, 3 * soup.position.size()}, soup.corner, soup.first_corner};
}

/// The soup of arrays. Errors (invalid input): lengths that do not fit, corners that are no vertex.
StatusOr<PolygonSoup> SoupOf(const MeshArrays& mesh);

/// A map in the terms of the arrays.
struct MeshMap {
  /// The arrays' points and polygons, all of them. To the plane: `texture` has every point of the map
  /// once, corner_texture says which one a corner has (of faces that the repair set aside: AttachUv);
  /// a polygon torn along a diagonal comes as its triangles.
  PolygonSoup mesh;
  /// Where polygons are torn: per corner of the arrays' its point in the plane, of a torn polygon
  /// that of one of its triangles; else empty.
  std::vector<Eigen::Vector2d> corner_uv;
  std::vector<Eigen::Vector3d> position;  ///< on the sphere: V; 0 where no polygon has the vertex
  /// With MapOptions::exact: the map that is linear on the triangles it was solved on.
  std::optional<ExactMesh> exact;
  /// Its outcome is "ok", or "inaccurate" for a map that misses kAccuracy. Of several components it
  /// is about all, with one of each.
  Certificate certificate;

  /// The point of a corner of the arrays' polygons. @pre a map to the plane.
  const Eigen::Vector2d& UvOfCorner(std::size_t corner) const {
    return corner_uv.empty() ? mesh.texture[mesh.corner_texture[corner]] : corner_uv[corner];
  }

  /// N x 2: the points of the map (libigl's TC); a view of `mesh`.
  Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>> uv() const;
  /// F x 3: per triangle the rows of uv() at its corners (libigl's FTC); a view of `mesh`.
  /// @pre all polygons are triangles, mapped to the plane.
  Eigen::Map<const Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>> f_uv() const;
};

/// What is known where there is no map, or one of some components only.
struct MapFailure {
  Certificate certificate;    ///< as far as the stages came; a proof names the arrays' vertices
  PreflightReport preflight;  ///< where the arrays are no surface
  /// Of the components that have a map, the others' faces without area (AttachUv); null: none has.
  std::shared_ptr<const MeshMap> partial;
};

struct MeshParts;

/// The surfaces of arrays, judged, repaired and taken apart once for any number of maps. This is the
/// one place where arrays become surfaces.
class PreparedMesh {
 public:
  /// `repair` as MeshOptions has it. Errors (invalid input): as SoupOf and SurfacesOf, and where no
  /// component is a surface; `failure`, unless null, receives the report.
  static StatusOr<PreparedMesh> Make(const MeshArrays& arrays, MapFailure* failure = nullptr,
                                     const std::string& repair = MeshOptions().repair);

  /// Maps every component (MapMesh). Options of another repair take the arrays apart anew. Errors:
  /// the worst of the components'; `failure`, unless null, then receives what there is.
  StatusOr<MeshMap> Map(const MapOptions& options, const SolveControl& control = {},
                        MapFailure* failure = nullptr) const;

  const PolygonSoup& soup() const { return *soup_; }
  const PreflightReport& report() const;
  const RepairSummary& repair() const;
  int num_components() const;
  /// The surface; several components one behind the other, joined by each call.
  std::shared_ptr<const Surface> surface() const;

 private:
  PreparedMesh() = default;

  std::shared_ptr<const PolygonSoup> soup_;
  std::shared_ptr<const MeshParts> parts_;
  std::string repair_;
};

/// Maps a mesh: PreparedMesh's Make and Map.
StatusOr<MeshMap> MapSurface(const MeshArrays& mesh, const MapOptions& options = {},
                             const SolveControl& control = {}, MapFailure* failure = nullptr);

/// The same of matrices: V x 3 points; F x n corners, n >= 3, an n-gon a row.
StatusOr<MeshMap> MapSurface(const Eigen::Ref<const Eigen::MatrixXd>& points,
                             const Eigen::Ref<const Eigen::MatrixXi>& faces,
                             const MapOptions& options = {}, const SolveControl& control = {},
                             MapFailure* failure = nullptr);

}  // namespace cirque
