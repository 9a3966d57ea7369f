#include "cirque/domains/map_arrays.h"

#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/count.h"
#include "cirque/domains/array_request.h"
#include "cirque/domains/atlas.h"
#include "cirque/domains/map_mesh.h"

namespace cirque {
namespace {

constexpr std::size_t kMost = std::numeric_limits<Index>::max();

/// Row lengths and corners of arrays, checked.
Status CheckArrays(const MeshArrays& mesh) {
  const auto refuse = [](const std::string& why) { return Status::InvalidInput(why); };
  const auto& [points, corners, first] = mesh;
  if (points.size() % 3 != 0) return refuse("points: three coordinates a vertex are needed");
  if (points.size() / 3 > kMost || corners.size() > kMost) {
    return refuse("more vertices or corners than 32 bits can number");
  }
  if (first.empty() && corners.size() % 3 != 0)
    return refuse("corners: three a triangle are needed");
  if (!first.empty() &&
      (first.front() != 0 || first.back() != static_cast<Index>(corners.size()))) {
    return refuse(
        fmt::format("first_corner: it must begin with 0 and end with {}, the number of "
                    "corners",
                    corners.size()));
  }
  for (std::size_t p = 0; p + 1 < first.size(); ++p) {
    if (first[p + 1] - first[p] >= 3) continue;
    return refuse(fmt::format("polygon {} has {}; at least 3 are needed", p,
                              Count(first[p + 1] - first[p], "corner")));
  }
  const auto num_vertices = static_cast<Index>(points.size() / 3);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (corners[c] >= 0 && corners[c] < num_vertices) continue;
    return refuse(fmt::format("corner {} is vertex {}; there are {} vertices, counted from 0", c,
                              corners[c], num_vertices));
  }
  return Status();
}

/// A map in the terms of the soup that its surface was made of.
MeshMap InSoup(const PolygonSoup& soup, const Surface& surface, const SurfaceMap& map) {
  MeshMap result;
  result.certificate = map.certificate;
  if (!map.IsOnSphere()) {
    result.mesh = AttachUv(soup, surface, map.uv);
    const bool is_torn = result.mesh.num_polygons() != soup.num_polygons();
    if (is_torn) result.corner_uv = UvOfCorners(soup, {{surface, map.uv}});
    return result;
  }
  result.mesh = soup;
  result.position.assign(soup.position.size(), Eigen::Vector3d::Zero());
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    result.position[surface.soup_vertex[v]] = map.position[v];
  }
  return result;
}

}  // namespace

StatusOr<PolygonSoup> SoupOf(const MeshArrays& mesh) {
  if (Status s = CheckArrays(mesh); !s.ok()) return s;
  PolygonSoup soup;
  soup.position.resize(mesh.points.size() / 3);
  for (std::size_t v = 0; v < soup.position.size(); ++v) {
    soup.position[v] = Eigen::Vector3d::Map(&mesh.points[3 * v]);
  }
  soup.corner.assign(mesh.corners.begin(), mesh.corners.end());
  if (!mesh.first_corner.empty()) {
    soup.first_corner.assign(mesh.first_corner.begin(), mesh.first_corner.end());
    return soup;
  }
  soup.first_corner.resize(mesh.corners.size() / 3 + 1);
  for (std::size_t p = 0; p < soup.first_corner.size(); ++p) {
    soup.first_corner[p] = static_cast<Index>(3 * p);
  }
  return soup;
}

Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>> MeshMap::uv() const {
  return {reinterpret_cast<const double*>(mesh.texture.data()),
          static_cast<Eigen::Index>(mesh.texture.size()), 2};
}

Eigen::Map<const Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>> MeshMap::f_uv() const {
  CHECK_EQ(mesh.corner.size(), 3 * static_cast<std::size_t>(mesh.num_polygons()));
  CHECK(position.empty()) << "a map to the sphere has points, not UVs";
  return {mesh.corner_texture.data(), mesh.num_polygons(), 3};
}

StatusOr<PreparedMesh> PreparedMesh::Make(const MeshArrays& arrays, MapFailure* failure,
                                          const std::string& repair) {
  StatusOr<PolygonSoup> soup = SoupOf(arrays);
  if (!soup.ok()) return soup.status();
  PreparedMesh mesh;
  mesh.soup_ = std::make_shared<const PolygonSoup>(*std::move(soup));
  mesh.repair_ = repair;
  const auto parts = std::make_shared<MeshParts>();
  Status status = TakeApart(*mesh.soup_, repair, parts.get());
  if (status.ok() && parts->Surfaces().empty()) status = parts->components[0].surface.status();
  if (!status.ok()) {
    if (failure) failure->preflight = std::move(parts->report);
    return status;
  }
  mesh.parts_ = parts;
  return mesh;
}

StatusOr<MeshMap> PreparedMesh::Map(const MapOptions& options, const SolveControl& control,
                                    MapFailure* failure) const {
  if (Status s = CheckOptions(options); !s.ok()) return s;
  if (options.mesh.repair != repair_) {
    const StatusOr<PreparedMesh> other = Make(ArraysOf(*soup_), failure, options.mesh.repair);
    return other.ok() ? other->Map(options, control, failure) : other.status();
  }
  const auto num_vertices = static_cast<Index>(soup_->position.size());
  const SurfaceRequest request = [&](const Surface& surface) {
    return RequestOf(options, num_vertices, surface);
  };
  const StatusOr<MappedMesh> mapped = MapMesh(parts_, options.mesh, request, control);
  if (!mapped.ok()) return mapped.status();
  if (mapped->status.ok()) {
    MeshMap map = InSoup(*soup_, *mapped->surface, mapped->map);
    if (mapped->map.exact_map) {
      map.exact = RefineByExactMap(*soup_, *mapped->solved_surface, *mapped->map.exact_map);
    }
    return map;
  }
  if (failure == nullptr) return mapped->status;
  failure->certificate = mapped->map.certificate;
  if (mapped->surface) {
    failure->partial =
        std::make_shared<const MeshMap>(InSoup(*soup_, *mapped->surface, mapped->map));
  }
  return mapped->status;
}

const PreflightReport& PreparedMesh::report() const { return parts_->report; }

const RepairSummary& PreparedMesh::repair() const { return parts_->repair; }

int PreparedMesh::num_components() const { return static_cast<int>(parts_->components.size()); }

std::shared_ptr<const Surface> PreparedMesh::surface() const {
  const std::vector<const Surface*> surfaces = parts_->Surfaces();
  if (surfaces.size() == 1) return {parts_, surfaces.front()};
  return std::make_shared<const Surface>(Joined(surfaces));
}

StatusOr<MeshMap> MapSurface(const MeshArrays& mesh, const MapOptions& options,
                             const SolveControl& control, MapFailure* failure) {
  const StatusOr<PreparedMesh> prepared = PreparedMesh::Make(mesh, failure, options.mesh.repair);
  return prepared.ok() ? prepared->Map(options, control, failure) : prepared.status();
}

StatusOr<MeshMap> MapSurface(const Eigen::Ref<const Eigen::MatrixXd>& points,
                             const Eigen::Ref<const Eigen::MatrixXi>& faces,
                             const MapOptions& options, const SolveControl& control,
                             MapFailure* failure) {
  if (points.cols() != 3 || faces.cols() < 3) {
    return Status::InvalidInput(
        fmt::format("points are V x 3 and faces F x 3 (n-gons: F x n); these are {} x {} and {} x "
                    "{}",
                    points.rows(), points.cols(), faces.rows(), faces.cols()));
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> by_row = points;
  const Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> corners = faces;
  std::vector<Index> first(faces.rows() + 1);
  for (std::size_t p = 0; p < first.size(); ++p) {
    first[p] = static_cast<Index>(p * static_cast<std::size_t>(faces.cols()));
  }
  const MeshArrays mesh = {{by_row.data(), static_cast<std::size_t>(by_row.size())},
                           {corners.data(), static_cast<std::size_t>(corners.size())},
                           first};
  return MapSurface(mesh, options, control, failure);
}

}  // namespace cirque
