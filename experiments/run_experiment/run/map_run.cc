#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cirque/domains/domain.h"
#include "cirque/domains/map_mesh.h"
#include "cirque/generators/known_maps.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/metrics/measure_map.h"

#include "experiments/common/sphere_files.h"
#include "experiments/run_experiment/run/carry_out.h"

namespace cirque {
namespace {

constexpr char kPlane[] = "plane";

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

/// Interior vertices flat; boundary vertices fixed to the angle sums that they have in the known
/// image, whose smooth map the circle pattern must then converge to. @pre the mesh's generator has
/// a known map that maps a disk.
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

/// How far the map of a generated surface is from the smooth conformal map that its generator is
/// known to have, after the best similarity between the two, relative to the known image's
/// diameter: `known_map_rms_error`, `known_map_max_error`, and `edge_length`, the mean edge of the
/// known image by the same diameter. Empty for other meshes.
std::map<std::string, double> KnownMapErrors(const MeshSpec& mesh, const Surface& surface,
                                             const CornerUv& uv) {
  const StatusOr<ConformalMap> known = KnownConformalMaps().Find(mesh.generator);
  if (!known.ok()) return {};
  const std::vector<Eigen::Vector2d> image = KnownImage(*known, surface);
  const Similarity similarity = FitSimilarity(uv.value, image);
  return {{"edge_length", RelativeEdgeLength(image)},
          {"known_map_rms_error", similarity.rms_error},
          {"known_map_max_error", similarity.max_error}};
}

/// Measures of a map as a whole: faces each in a plane of their own have none.
constexpr std::array kOfOnePlane = {"overlap_area",  "covered_twice_area", "cut_length",
                                    "flipped_share", "resolution",         "resolution_unit_area"};

bool IsOfOnePlane(const std::string& measure) {
  return std::find(kOfOnePlane.begin(), kOfOnePlane.end(), measure) != kOfOnePlane.end();
}

/// The certificate of the map in place of what the result has, whose times it takes over.
void TakeCertificate(Certificate certificate, RunResult* result) {
  const StageSeconds& before = result->certificate.seconds;
  certificate.seconds.read = before.read;
  certificate.seconds.preflight = before.preflight;
  certificate.seconds.subdivide = before.subdivide;
  result->certificate = std::move(certificate);
}

/// The map, of one to the sphere every face in a plane of its own.
CornerUv InPlanes(const Triangulation& t, const SurfaceMap& map) {
  if (!map.IsOnSphere()) return map.uv;
  const EdgeLengths chords = ChordLengths(t, map.position);
  return FacesInPlane(MeasureSurface(t, chords));
}

Status AddMeasures(std::vector<std::string> measures, const Surface& surface, const SurfaceMap& map,
                   RunResult* result) {
  if (map.IsOnSphere()) std::erase_if(measures, IsOfOnePlane);
  if (measures.empty()) return Status();
  auto figures = MeasureFigures(surface.triangulation, MeasureEdgeLengths(surface),
                                InPlanes(surface.triangulation, map), measures);
  if (!figures.ok()) return figures.status();
  result->figures.merge(*figures);
  return Status();
}

StatusOr<MapRequest> RequestOf(const PlannedRun& run, const Surface& surface) {
  MapRequest request;
  request.domain = run.method.domain;
  request.options = run.method.options;
  if (request.domain != kPlane || !run.mesh.known_boundary) return request;
  StatusOr<ConeTargets> targets = KnownBoundaryTargets(run.mesh, surface);
  if (!targets.ok()) return targets.status();
  request.targets = *std::move(targets);
  return request;
}

/// A closed surface's known map has periods: it is known up to more than a similarity. New
/// vertices do not lie on the smooth surface.
bool HasKnownImage(const PlannedRun& run, const Surface& surface) {
  return run.method.domain == kPlane && run.mesh.subdivisions == 0 && run.mesh.decimate == 0 &&
         !BoundaryLoops(surface.triangulation).empty();
}

}  // namespace

Status MapRun(const PlannedRun& run, const PolygonSoup& soup,
              const std::shared_ptr<const MeshParts>& parts, RunResult* result) {
  const SurfaceRequest request = [&](const Surface& of) { return RequestOf(run, of); };
  const StatusOr<MappedMesh> mapped = MapMesh(parts, MeshOptions(), request, SolveControl());
  if (!mapped.ok()) return mapped.status();
  const SurfaceMap& map = mapped->map;
  TakeCertificate(map.certificate, result);
  if (!mapped->status.ok()) return mapped->status;
  const Surface& surface = *mapped->surface;
  if (HasKnownImage(run, surface)) {
    result->figures.merge(KnownMapErrors(run.mesh, surface, map.uv));
  }
  if (run.keep_map) {
    result->map = map.IsOnSphere() ? SphereMesh(soup, surface, map.position)
                                   : AttachUv(soup, surface, map.uv);
  }
  return AddMeasures(run.measures, surface, map, result);
}

}  // namespace cirque
