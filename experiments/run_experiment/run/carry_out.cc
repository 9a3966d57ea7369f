#include "experiments/run_experiment/run/carry_out.h"

#include <memory>
#include <string>
#include <utility>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/atlas.h"
#include "cirque/domains/map_mesh.h"
#include "cirque/io/io.h"
#include "cirque/mesh/surface.h"

#include "experiments/common/process.h"
#include "experiments/run_experiment/config/remeshing.h"

namespace cirque {
namespace {

constexpr int kReferenceRepeats = 3;

StatusOr<PolygonSoup> ReadSoup(const MeshSpec& mesh, const std::string& path) {
  if (mesh.generator.empty()) return ReadMesh(path);
  const StatusOr<MeshGenerator> generator = MeshGenerators().Find(mesh.generator);
  if (!generator.ok()) return generator.status();
  return (*generator)(mesh.generator_options);
}

/// What was read, and the surfaces it is.
struct Input {
  PolygonSoup soup;
  std::shared_ptr<const MeshParts> parts;
};

/// The input taken apart, and its size in the result whatever the status.
StatusOr<std::shared_ptr<const MeshParts>> Check(const PolygonSoup& soup, const std::string& repair,
                                                 RunResult* result) {
  const auto parts = std::make_shared<MeshParts>();
  const Status status = TakeApart(soup, repair, parts.get());
  result->vertices = parts->report.num_vertices;
  result->triangles = parts->report.num_triangles;
  if (!status.ok()) return status;
  return std::shared_ptr<const MeshParts>(parts);
}

/// As the config has it: coarser, then finer.
StatusOr<PolygonSoup> Remeshed(const MeshSpec& mesh, PolygonSoup triangles) {
  if (mesh.decimate > 0) {
    StatusOr<PolygonSoup> coarse = Decimate(triangles, mesh.decimate);
    if (!coarse.ok()) return coarse;
    triangles = *std::move(coarse);
  }
  return Subdivide(triangles, mesh.subdivision, mesh.subdivisions);
}

StatusOr<Input> ReadInput(const MeshSpec& mesh, const std::string& path, RunResult* result) {
  auto& seconds = result->certificate.seconds;
  const Timer read_timer;
  StatusOr<PolygonSoup> soup = ReadSoup(mesh, path);
  seconds.read = read_timer.Seconds();
  if (!soup.ok()) return soup.status();
  auto parts = Check(*soup, mesh.repair, result);
  if (!parts.ok()) return parts.status();
  seconds.preflight = (*parts)->seconds;
  if (mesh.subdivisions > 0 || mesh.decimate > 0) {
    const Timer timer;
    soup = Remeshed(mesh, TrianglesOf(Joined((*parts)->Surfaces())));
    if (!soup.ok()) return soup.status();
    parts = Check(*soup, MeshSpec().repair, result);
    seconds.subdivide = timer.Seconds();
    if (!parts.ok()) return parts.status();
  }
  return Input{*std::move(soup), *std::move(parts)};
}

/// The one surface that the input is; what keeps it from that otherwise.
StatusOr<const Surface*> OneSurface(const MeshParts& parts) {
  if (!parts.IsOne()) {
    return Status::InvalidInput(
        "the mesh has several components, " + parts.Sizes() +
        ", and energies are minimised on one surface: where: components == 1 leaves it out");
  }
  const StatusOr<Surface>& surface = parts.components[0].surface;
  return surface.ok() ? StatusOr<const Surface*>(&*surface) : surface.status();
}

/// What the run does with its mesh.
Status Act(const PlannedRun& run, const Input& input, RunResult* result) {
  if (!run.method.peer.empty()) {
    return PeerRun(run, TrianglesOf(Joined(input.parts->Surfaces())), result);
  }
  if (!run.method.trial.IsAskedFor()) return MapRun(run, input.soup, input.parts, result);
  const StatusOr<const Surface*> surface = OneSurface(*input.parts);
  return surface.ok() ? EnergyRun(run, **surface, result) : surface.status();
}

Status Run(const PlannedRun& run, const std::string& path, RunResult* result) {
  const Timer timer;
  const double cpu_before = ProcessCpuSeconds();
  const StatusOr<Input> input = ReadInput(run.mesh, path, result);
  const double cpu_at_map = ProcessCpuSeconds();
  const Status status = input.ok() ? Act(run, *input, result) : input.status();
  const double cpu_after = ProcessCpuSeconds();
  if (run.method.MakesMapItself()) {  // what is timed by itself is timed by others
    result->seconds = timer.Seconds();
    result->cpu_seconds = cpu_after - cpu_before;
    result->map_cpu_seconds = cpu_after - cpu_at_map;
    result->peak_memory_mib = PeakMemoryMib();
  }
  const bool is_one = input.ok() && input->parts->IsOne();
  if (run.reference && is_one && input->parts->components[0].surface.ok()) {
    result->reference =
        TimeReferenceFactorization(*input->parts->components[0].surface, kReferenceRepeats);
  }
  return status;
}

}  // namespace

RunResult ParameterizeRun(const PlannedRun& run, const std::string& mesh_path) {
  RunResult result;
  const Status status = Run(run, mesh_path, &result);
  const bool has_outcome =
      !run.method.MakesMapItself() || result.certificate.outcome == kInaccurate;
  if (status.ok() && has_outcome) return result;
  result.certificate.outcome = ToString(status.code());
  result.certificate.message = status.message();
  return result;
}

}  // namespace cirque
