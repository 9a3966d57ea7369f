#include "experiments/run_experiment/run/map_run.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cirque/domains/domain.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/metrics/measure_map.h"

#include "experiments/common/sphere_files.h"
#include "experiments/run_experiment/run/known_map.h"

namespace cirque {
namespace {

constexpr char kPlane[] = "plane";

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

/// A closed surface's known map has periods: it is known up to more than a similarity. Midpoints
/// do not lie on the smooth surface.
bool HasKnownImage(const PlannedRun& run, const Surface& surface) {
  return run.method.domain == kPlane && run.mesh.subdivisions == 0 &&
         !BoundaryLoops(surface.triangulation).empty();
}

}  // namespace

Status MapRun(const PlannedRun& run, const PolygonSoup& soup, const Surface& surface,
              RunResult* result) {
  const StatusOr<MapRequest> request = RequestOf(run, surface);
  if (!request.ok()) return request.status();
  Certificate failed;
  StatusOr<SurfaceMap> map = MapSurface(surface, *request, SolveControl(), &failed);
  TakeCertificate(std::move(map.ok() ? map->certificate : failed), result);
  if (!map.ok()) return map.status();
  if (HasKnownImage(run, surface)) {
    result->figures.merge(KnownMapErrors(run.mesh, surface, map->uv));
  }
  if (run.keep_map) {
    result->map = map->IsOnSphere() ? SphereMesh(soup, surface, map->position)
                                    : AttachUv(soup, surface, map->uv);
  }
  return AddMeasures(run.measures, surface, *map, result);
}

}  // namespace cirque
