#include "experiments/run_experiment/run/carry_out.h"

#include <utility>

#include "cirque/core/solve_summary.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/surface.h"

#include "experiments/common/process.h"

namespace cirque {
namespace {

constexpr int kReferenceRepeats = 3;

StatusOr<PolygonSoup> ReadSoup(const MeshSpec& mesh, const std::string& path) {
  if (mesh.generator.empty()) return ReadMesh(path);
  const StatusOr<MeshGenerator> generator = MeshGenerators().Find(mesh.generator);
  if (!generator.ok()) return generator.status();
  return (*generator)(mesh.generator_options);
}

/// What was read, and the surface it is.
struct Input {
  PolygonSoup soup;
  Surface surface;
};

/// The input's surface, and its size in the result whatever the status.
StatusOr<Surface> Check(const PolygonSoup& soup, RunResult* result) {
  PreflightReport report;
  StatusOr<Surface> surface = Preflight(soup, &report);
  result->vertices = report.num_vertices;
  result->triangles = report.num_triangles;
  return surface;
}

StatusOr<Input> ReadInput(const MeshSpec& mesh, const std::string& path, RunResult* result) {
  auto& seconds = result->certificate.seconds;
  const Timer read_timer;
  StatusOr<PolygonSoup> soup = ReadSoup(mesh, path);
  seconds.read = read_timer.Seconds();
  if (!soup.ok()) return soup.status();
  const Timer preflight_timer;
  StatusOr<Surface> surface = Check(*soup, result);
  seconds.preflight = preflight_timer.Seconds();
  if (!surface.ok()) return surface.status();
  if (mesh.subdivisions > 0) {
    const Timer timer;
    *soup = MidpointSubdivision(TrianglesOf(*surface), mesh.subdivisions);
    surface = Check(*soup, result);
    seconds.subdivide = timer.Seconds();
    if (!surface.ok()) return surface.status();
  }
  return Input{*std::move(soup), *std::move(surface)};
}

Status Run(const PlannedRun& run, const std::string& path, RunResult* result) {
  const Timer timer;
  const double cpu_before = ProcessCpuSeconds();
  const StatusOr<Input> input = ReadInput(run.mesh, path, result);
  const double cpu_at_map = ProcessCpuSeconds();
  const Status status =
      input.ok() ? MapRun(run, input->soup, input->surface, result) : input.status();
  const double cpu_after = ProcessCpuSeconds();
  result->seconds = timer.Seconds();
  result->cpu_seconds = cpu_after - cpu_before;
  result->map_cpu_seconds = cpu_after - cpu_at_map;
  result->peak_memory_mib = PeakMemoryMib();
  if (run.reference && input.ok()) {
    result->reference = TimeReferenceFactorization(input->surface, kReferenceRepeats);
  }
  return status;
}

}  // namespace

RunResult ParameterizeRun(const PlannedRun& run, const std::string& mesh_path) {
  RunResult result;
  const Status status = Run(run, mesh_path, &result);
  if (status.ok() && result.certificate.outcome == kInaccurate) return result;
  result.certificate.outcome = ToString(status.code());
  result.certificate.message = status.message();
  return result;
}

}  // namespace cirque
