// What every circle pattern costs at least, for a whole process to be timed.
#include <cstdio>
#include <string>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"

#include "experiments/common/reference_factorization.h"
#include "experiments/studies/studies.h"

namespace cirque {
namespace {

/// As many texture coordinates as a map would have.
CornerUv UvFromAbove(const Surface& surface) {
  CornerUv uv;
  for (const Index v : surface.triangulation.vertex) {
    uv.value.emplace_back(surface.position[v].head<2>());
  }
  return uv;
}

Status PayLowerBound(const std::string& path) {
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
  if (Status status = WriteMesh(OutputFile(), map); !status.ok()) return status;
  fmt::print(
      "{:<40} {:>9} triangles {:>9.4f} s read {:>9.4f} s dual factorization {:>9.4f} s write\n",
      path, surface->triangulation.num_faces(), read_seconds, dual.seconds, writing.Seconds());
  return Status();
}

}  // namespace

Status RunLowerBound(const StudyCall& call) {
  if (call.arguments.size() != 1 || OutputFile().empty()) {
    return Status::InvalidInput("one mesh and --output are needed; see --help");
  }
  return PayLowerBound(call.arguments.front());
}

}  // namespace cirque
