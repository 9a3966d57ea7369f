#include "experiments/run_experiment/run/map_errors.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "cirque/domains/map_mesh.h"
#include "cirque/math/similarity.h"

#include "experiments/run_experiment/config/remeshing.h"

namespace cirque {
namespace {

/// Mean edge length of corner images, relative to their extent as SimilarityFit measures it.
double RelativeEdgeLength(const std::vector<Eigen::Vector2d>& image) {
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : image) centroid += p / static_cast<double>(image.size());
  double sum = 0, extent = 0;
  for (std::size_t h = 0; h < image.size(); ++h) {
    sum += (image[h] - image[h % 3 == 2 ? h - 2 : h + 1]).norm();
    extent = std::max(extent, (image[h] - centroid).norm());
  }
  return sum / static_cast<double>(image.size()) / (2 * extent);
}

/// The image of every vertex; nothing where a seam gives it several.
std::optional<std::vector<Eigen::Vector2d>> VertexImages(const Triangulation& t,
                                                         const CornerUv& uv) {
  std::vector<Eigen::Vector2d> image(t.num_vertices);
  std::vector<bool> known(t.num_vertices, false);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index v = t.vertex[h];
    if (known[v] && image[v] != uv.value[h]) return std::nullopt;
    image[v] = uv.value[h];
    known[v] = true;
  }
  return image;
}

/// Where the vertices of a mesh lie in the map of its refinement, whose first vertices they are.
StatusOr<std::optional<std::vector<Eigen::Vector2d>>> RefinedImages(const PlannedRun& run,
                                                                    const PolygonSoup& refined,
                                                                    Index num_vertices) {
  const auto parts = std::make_shared<MeshParts>();
  if (Status s = TakeApart(refined, MeshSpec().repair, parts.get()); !s.ok()) return s;
  MapRequest request;
  request.domain = run.method.domain;
  request.options = run.method.options;
  const SurfaceRequest same = [&](const Surface&) { return StatusOr<MapRequest>(request); };
  const auto mapped = MapMesh(parts, MeshOptions(), same, SolveControl());
  if (!mapped.ok()) return mapped.status();
  if (!mapped->status.ok()) return mapped->status;
  const Surface& surface = *mapped->surface;
  const auto all = VertexImages(surface.triangulation, mapped->map.uv);
  if (!all) return std::optional<std::vector<Eigen::Vector2d>>();
  std::vector<Eigen::Vector2d> images(num_vertices, Eigen::Vector2d::Constant(kUnset));
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    if (surface.soup_vertex[v] < num_vertices) images[surface.soup_vertex[v]] = (*all)[v];
  }
  return std::optional(std::move(images));
}

}  // namespace

std::vector<Eigen::Vector2d> KnownImage(const ConformalMap& map, const Surface& surface) {
  std::vector<Eigen::Vector2d> image;
  for (const Index v : surface.triangulation.vertex) {
    image.push_back(map.to_plane(surface.position[v]));
  }
  return image;
}

std::map<std::string, double> KnownMapErrors(const MeshSpec& mesh, const Surface& surface,
                                             const CornerUv& uv) {
  const StatusOr<ConformalMap> known = KnownConformalMaps().Find(mesh.generator);
  if (!known.ok()) return {};
  const std::vector<Eigen::Vector2d> image = KnownImage(*known, surface);
  const SimilarityFit fit = FitSimilarity(uv.value, image);
  return {{"edge_length", RelativeEdgeLength(image)},
          {"known_map_rms_error", fit.rms_error},
          {"known_map_max_error", fit.max_error}};
}

StatusOr<std::map<std::string, double>> RefinedMapErrors(const PlannedRun& run,
                                                         const Surface& surface,
                                                         const SurfaceMap& map) {
  std::map<std::string, double> errors;
  if (run.method.domain != MethodSpec().domain || map.IsOnSphere()) return errors;
  const auto image = VertexImages(surface.triangulation, map.uv);
  if (!image) return errors;
  const auto refined = Subdivide(TrianglesOf(surface), run.mesh.subdivision, 1);
  if (!refined.ok()) return refined.status().In("against_refined");
  const auto finer = RefinedImages(run, *refined, surface.triangulation.num_vertices);
  if (!finer.ok()) return finer.status().In("against_refined");
  if (!*finer) return errors;
  const SimilarityFit fit = FitSimilarity(*image, **finer);
  return std::map<std::string, double>{{"edge_length", RelativeEdgeLength(map.uv.value)},
                                       {"refined_map_rms_error", fit.rms_error},
                                       {"refined_map_max_error", fit.max_error}};
}

}  // namespace cirque
