// The yardstick beside which the times of other programs and machines can be read.
#include <iostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/solve_summary.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/surface.h"

#include "experiments/common/blas_threads.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/common/reference_factorization.h"

DECLARE_bool(help);
DEFINE_int32(repeats, 3, "factorizations a mesh; the fastest counts");
DEFINE_int32(subdivisions, 0, "how often triangles are split in four at their edges' midpoints");
DEFINE_bool(floor, false,
            "only what every circle pattern does, once, for a whole process to be timed");
DEFINE_string(output, "", "file that the mesh is written to");

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/reference_factorization/";
constexpr char kUsage[] =
    "reference_factorization [FLAGS] MESH ...\n"
    "Times one analysis and factorization of each mesh's V x V cotangent Laplacian. With --floor\n"
    "it is the floor of any circle pattern instead, as a process to be timed whole: reads the\n"
    "mesh, factors its F x F dual Laplacian once and writes it with texture coordinates, its x\n"
    "and y.\n\n";

ReferenceFactorization Fastest(const Surface& surface) {
  ReferenceFactorization best = TimeReferenceFactorization(surface);
  for (int i = 1; i < FLAGS_repeats; ++i) {
    const ReferenceFactorization again = TimeReferenceFactorization(surface);
    if (again.cpu_seconds < best.cpu_seconds) best = again;
  }
  return best;
}

/// The triangles of a file, split as asked.
StatusOr<PolygonSoup> ReadTriangles(const std::string& path) {
  StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok() || FLAGS_subdivisions == 0) return soup;
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  if (!surface.ok()) return surface.status().In(path);
  return MidpointSubdivision(TrianglesOf(*surface), FLAGS_subdivisions);
}

Status TimeMesh(const std::string& path) {
  const StatusOr<PolygonSoup> soup = ReadTriangles(path);
  if (!soup.ok()) return soup.status();
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  if (!surface.ok()) return surface.status().In(path);
  const ReferenceFactorization best = Fastest(*surface);
  std::cout << fmt::format("{:<40} {:>9} triangles {:>9.4f} s wall {:>9.4f} s CPU\n", path,
                           surface->triangulation.num_faces(), best.seconds, best.cpu_seconds);
  return FLAGS_output.empty() ? Status() : WriteMesh(FLAGS_output, *soup);
}

/// As many texture coordinates as a map would have.
CornerUv UvFromAbove(const Surface& surface) {
  CornerUv uv;
  for (const Index v : surface.triangulation.vertex) {
    uv.value.emplace_back(surface.position[v].head<2>());
  }
  return uv;
}

Status PayFloor(const std::string& path) {
  const Timer reading;
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) return soup.status();
  const double read_seconds = reading.Seconds();
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  if (!surface.ok()) return surface.status().In(path);
  const ReferenceFactorization dual = TimeDualFactorization(surface->triangulation);
  const PolygonSoup map = AttachUv(*soup, *surface, UvFromAbove(*surface));
  const Timer writing;
  if (Status status = WriteMesh(FLAGS_output, map); !status.ok()) return status;
  std::cout << fmt::format(
      "{:<40} {:>9} triangles {:>9.4f} s read {:>9.4f} s dual factorization {:>9.4f} s write\n",
      path, surface->triangulation.num_faces(), read_seconds, dual.seconds, writing.Seconds());
  return Status();
}

Status CheckArguments(const std::vector<std::string>& meshes) {
  if (meshes.empty()) return Status::InvalidInput("no mesh given; see --help");
  if (FLAGS_repeats < 1) return Status::InvalidInput("--repeats needs a number from 1 on");
  if (FLAGS_subdivisions < 0)
    return Status::InvalidInput("--subdivisions needs a number from 0 on");
  if (!FLAGS_output.empty() && meshes.size() > 1) {
    return Status::InvalidInput("--output takes one mesh");
  }
  if (FLAGS_floor && (FLAGS_output.empty() || FLAGS_subdivisions > 0)) {
    return Status::InvalidInput("--floor needs --output, and no --subdivisions");
  }
  return Status();
}

int Main(int argc, char** argv) {
  UseOneBlasThread();
  const StatusOr<std::vector<std::string>> meshes = ParseFlags(argc, argv, kSource);
  Status status = meshes.status();
  if (FLAGS_help) {
    std::cout << kUsage << FlagHelp(kSource);
    return 0;
  }
  if (status.ok()) status = CheckArguments(*meshes);
  for (std::size_t i = 0; status.ok() && i < meshes->size(); ++i) {
    status = FLAGS_floor ? PayFloor((*meshes)[i]) : TimeMesh((*meshes)[i]);
  }
  if (!status.ok()) std::cerr << "reference_factorization: " << status.message() << "\n";
  return ExitStatus(status.code());
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::Main(argc, argv); }
