// The yardstick beside which the times of other programs and machines can be read.
#include <iostream>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/mesh/io.h"
#include "cirque/mesh/preflight.h"

#include "experiments/common/blas_threads.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/common/reference_factorization.h"

DECLARE_bool(help);
DEFINE_int32(repeats, 3, "factorizations a mesh; the fastest counts");

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/reference_factorization/";
constexpr char kUsage[] =
    "reference_factorization [FLAGS] MESH ...\n"
    "Times one analysis and factorization of each mesh's V x V cotangent Laplacian.\n\n";

Status TimeMesh(const std::string& path) {
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) return soup.status();
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  if (!surface.ok()) return surface.status().In(path);
  ReferenceFactorization best = TimeReferenceFactorization(*surface);
  for (int i = 1; i < FLAGS_repeats; ++i) {
    const ReferenceFactorization again = TimeReferenceFactorization(*surface);
    if (again.cpu_seconds < best.cpu_seconds) best = again;
  }
  std::cout << fmt::format("{:<40} {:>9} triangles {:>9.4f} s wall {:>9.4f} s CPU\n", path,
                           surface->triangulation.num_faces(), best.seconds, best.cpu_seconds);
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
  if (status.ok() && meshes->empty()) status = Status::InvalidInput("no mesh given; see --help");
  for (std::size_t i = 0; status.ok() && i < meshes->size(); ++i) status = TimeMesh((*meshes)[i]);
  if (!status.ok()) std::cerr << "reference_factorization: " << status.message() << "\n";
  return ExitStatus(status.code());
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::Main(argc, argv); }
