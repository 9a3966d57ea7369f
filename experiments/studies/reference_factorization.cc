// The yardstick beside which the times of other programs and machines can be read.
#include "experiments/common/reference_factorization.h"

#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/surface.h"

#include "experiments/studies/studies.h"

DEFINE_int32(repeats, 3, "factorizations a mesh; the fastest counts");
DEFINE_int32(subdivisions, 0, "how often triangles are split in four at their edges' midpoints");

namespace cirque {
namespace {

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
  const ReferenceFactorization best = TimeReferenceFactorization(*surface, FLAGS_repeats);
  fmt::print("{:<40} {:>9} triangles {:>9.4f} s wall {:>9.4f} s CPU\n", path,
             surface->triangulation.num_faces(), best.seconds, best.cpu_seconds);
  return OutputFile().empty() ? Status() : WriteMesh(OutputFile(), *soup);
}

Status CheckArguments(const StudyCall& call) {
  if (call.arguments.empty()) return Status::InvalidInput("no mesh given; see --help");
  if (FLAGS_repeats < 1) return Status::InvalidInput("--repeats needs a number from 1 on");
  if (FLAGS_subdivisions < 0) {
    return Status::InvalidInput("--subdivisions needs a number from 0 on");
  }
  if (!OutputFile().empty() && call.arguments.size() > 1) {
    return Status::InvalidInput("--output takes one mesh");
  }
  return Status();
}

}  // namespace

Status RunReferenceFactorization(const StudyCall& call) {
  Status status = CheckArguments(call);
  for (std::size_t i = 0; status.ok() && i < call.arguments.size(); ++i) {
    status = TimeMesh(call.arguments[i]);
  }
  return status;
}

}  // namespace cirque
