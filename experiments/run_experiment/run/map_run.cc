#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cirque/domains/domain.h"
#include "cirque/domains/map_mesh.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/metrics/measure_map.h"

#include "experiments/common/sphere_files.h"
#include "experiments/run_experiment/run/carry_out.h"
#include "experiments/run_experiment/run/map_errors.h"

namespace cirque {
namespace {

constexpr char kPlane[] = "plane";

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
  std::map<std::string, double> errors;
  if (HasKnownImage(run, surface)) errors = KnownMapErrors(run.mesh, surface, map.uv);
  if (errors.empty() && run.against_refined) {
    auto of_refined = RefinedMapErrors(run, surface, map);
    if (!of_refined.ok()) return of_refined.status();
    errors = *std::move(of_refined);
  }
  result->figures.merge(errors);
  if (run.keep_map) {
    result->map = map.IsOnSphere() ? SphereMesh(soup, surface, map.position)
                                   : AttachUv(soup, surface, map.uv);
  }
  return AddMeasures(run.measures, surface, map, result);
}

}  // namespace cirque
