#include "experiments/run_experiment/map_cell.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <glog/logging.h>

#include "cirque/domains/registry.h"
#include "cirque/domains/sphere.h"
#include "cirque/metrics/measure_map.h"
#include "cirque/metrics/spherical.h"

#include "experiments/common/sphere_files.h"
#include "experiments/run_experiment/known_map.h"

namespace cirque {
namespace {

/// Measures of a map as a whole: faces each in a plane of their own have none.
constexpr std::array kOfOnePlane = {"overlap_area",  "covered_twice_area", "cut_length",
                                    "flipped_share", "resolution",         "resolution_unit_area"};

bool IsOfOnePlane(const std::string& measure) {
  return std::find(kOfOnePlane.begin(), kOfOnePlane.end(), measure) != kOfOnePlane.end();
}

/// The certificate of the map in place of what the result has, whose times it takes over.
void TakeCertificate(Certificate certificate, RunResult* result) {
  certificate.seconds.merge(result->certificate.seconds);
  result->certificate = std::move(certificate);
}

Status AddMeasures(const std::vector<std::string>& measures, const Surface& surface,
                   const CornerUv& uv, RunResult* result) {
  if (measures.empty()) return Status();
  auto figures = MeasureFigures(surface.triangulation, MeasureEdgeLengths(surface), uv, measures);
  if (!figures.ok()) return figures.status();
  result->certificate.values.merge(*figures);
  return Status();
}

Status MapToSphereOf(const Cell& cell, const PolygonSoup& soup, const Surface& surface,
                     RunResult* result) {
  SphereMap map;
  const Status status =
      MapToSphere(surface, SphereOptions(), cell.method.options, SolveControl(), &map);
  TakeCertificate(std::move(map.certificate), result);
  if (!status.ok()) return status;
  if (cell.keep_map) result->map = SphereMesh(soup, surface, map);
  const Triangulation& t = surface.triangulation;
  std::vector<std::string> measures = cell.measures;
  std::erase_if(measures, IsOfOnePlane);
  return AddMeasures(measures, surface, FacesInPlane(t, ChordLengths(t, map.position)), result);
}

Status MapToThePlane(const Cell& cell, const Surface& surface, Parameterization* map) {
  const ParameterizeOptions& options = cell.method.options;
  if (!cell.mesh.known_boundary) {
    return ParameterizeWithCones(surface, nullptr, options, SolveControl(), map);
  }
  const StatusOr<ConeTargets> targets = KnownBoundaryTargets(cell.mesh, surface);
  if (!targets.ok()) return targets.status();
  return Parameterize(surface, *targets, nullptr, options, SolveControl(), map);
}

/// A closed surface's known map has periods: it is known up to more than a similarity. Midpoints
/// do not lie on the smooth surface.
bool HasKnownImage(const Cell& cell, const Surface& surface) {
  return cell.method.domain == "plane" && cell.mesh.subdivisions == 0 &&
         !BoundaryLoops(surface.triangulation).empty();
}

}  // namespace

Status MapCell(const Cell& cell, const PolygonSoup& soup, const Surface& surface,
               RunResult* result) {
  const Domain* domain = FindDomain(cell.method.domain);
  CHECK(domain != nullptr) << cell.method.domain;
  if (domain->name == "sphere") return MapToSphereOf(cell, soup, surface, result);
  Parameterization map;
  const Status status =
      domain->map == nullptr
          ? MapToThePlane(cell, surface, &map)
          : domain->map(surface, DomainOptions(), cell.method.options, SolveControl(), &map);
  TakeCertificate(std::move(map.certificate), result);
  if (!status.ok()) return status;
  if (HasKnownImage(cell, surface)) {
    result->certificate.values.merge(KnownMapErrors(cell.mesh, surface, map.uv));
  }
  if (cell.keep_map) result->map = AttachUv(soup, surface, map.uv);
  return AddMeasures(cell.measures, surface, map.uv, result);
}

}  // namespace cirque
