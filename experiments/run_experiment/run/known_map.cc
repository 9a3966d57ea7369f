#include "experiments/run_experiment/run/known_map.h"

#include <algorithm>
#include <cmath>

#include "cirque/generators/known_maps.h"
#include "cirque/metrics/measure_map.h"

namespace cirque {
namespace {

/// Mean edge length of corner images, relative to their extent as Similarity measures it.
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

std::vector<Eigen::Vector2d> KnownImage(const ConformalMap& map, const Surface& surface) {
  std::vector<Eigen::Vector2d> image;
  for (const Index v : surface.triangulation.vertex) {
    image.push_back(map.to_plane(surface.position[v]));
  }
  return image;
}

/// The angle at corner h between the images of the edges to the next and the previous corner [rad].
double ImageAngle(const std::vector<Eigen::Vector2d>& image, Index h) {
  const Eigen::Vector2d a = image[Triangulation::Next(h)] - image[h];
  const Eigen::Vector2d b = image[Triangulation::Prev(h)] - image[h];
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

}  // namespace

ConeTargets KnownBoundaryTargets(const MeshSpec& mesh, const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const auto image = KnownImage(*KnownConformalMaps().Find(mesh.generator), surface);
  ConeTargets targets = FreeBoundaryTargets(t);
  std::vector<double> sum(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) sum[t.vertex[h]] += ImageAngle(image, h);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (targets.lower[v] == 0) targets.lower[v] = targets.upper[v] = sum[v];
  }
  return targets;
}

std::map<std::string, double> KnownMapErrors(const MeshSpec& mesh, const Surface& surface,
                                             const CornerUv& uv) {
  const StatusOr<ConformalMap> known = KnownConformalMaps().Find(mesh.generator);
  if (!known.ok()) return {};
  const std::vector<Eigen::Vector2d> wanted = KnownImage(*known, surface);
  const Similarity similarity = FitSimilarity(uv.value, wanted);
  return {{"edge_length", RelativeEdgeLength(wanted)},
          {"known_map_rms_error", similarity.rms_error},
          {"known_map_max_error", similarity.max_error}};
}

}  // namespace cirque
