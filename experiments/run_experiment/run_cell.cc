#include "experiments/run_experiment/run_cell.h"

#include "cirque/core/timer.h"
#include "cirque/mesh/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/metrics/measure_map.h"

#include "experiments/run_experiment/known_map.h"

namespace cirque {
namespace {

StatusOr<PolygonSoup> MakeSoup(const MeshSpec& mesh, const std::string& path) {
  if (mesh.generator.empty()) return ReadMesh(path);
  const StatusOr<MeshGenerator> generator = MeshGenerators().Find(mesh.generator);
  if (!generator.ok()) return generator.status();
  return (*generator)(mesh.generator_options);
}

Status Parameterize(const Cell& cell, const Surface& surface, Parameterization* result) {
  const ParameterizeOptions& options = cell.method.options;
  if (!cell.mesh.known_boundary) {
    return ParameterizeWithCones(surface, nullptr, options, SolveControl(), result);
  }
  const StatusOr<ConeTargets> targets = KnownBoundaryTargets(cell.mesh, surface);
  if (!targets.ok()) return targets.status();
  return cirque::Parameterize(surface, *targets, nullptr, options, SolveControl(), result);
}

Status Run(const Cell& cell, const std::string& path, RunResult* result) {
  auto& seconds = result->certificate.seconds;
  const Timer read_timer;
  const StatusOr<PolygonSoup> soup = MakeSoup(cell.mesh, path);
  seconds["read"] = read_timer.Seconds();
  if (!soup.ok()) return soup.status();

  const Timer preflight_timer;
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  seconds["preflight"] = preflight_timer.Seconds();
  result->vertices = report.num_vertices;
  result->triangles = report.num_triangles;
  if (!surface.ok()) return surface.status();

  Parameterization parameterization;
  const Status status = Parameterize(cell, *surface, &parameterization);
  parameterization.certificate.seconds.merge(seconds);
  result->certificate = std::move(parameterization.certificate);
  if (status.ok() && !cell.measures.empty()) {
    auto figures = MeasureFigures(surface->triangulation, MeasureEdgeLengths(*surface),
                                  parameterization.uv, cell.measures);
    if (!figures.ok()) return figures.status();
    result->certificate.values.merge(*figures);
  }
  // A closed surface's known map has periods: it is known up to more than a similarity.
  if (status.ok() && !BoundaryLoops(surface->triangulation).empty()) {
    result->certificate.values.merge(KnownMapErrors(cell.mesh, *surface, parameterization.uv));
  }
  if (status.ok() && cell.keep_map) {
    result->map = AttachUv(*soup, *surface, parameterization.uv);
  }
  return status;
}

}  // namespace

RunResult ParameterizeCell(const Cell& cell, const std::string& mesh_path) {
  RunResult result;
  const Status status = Run(cell, mesh_path, &result);
  result.certificate.outcome = ToString(status.code());
  result.certificate.message = status.message();
  return result;
}

}  // namespace cirque
