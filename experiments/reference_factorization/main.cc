// The yardstick beside which the times of other programs and machines can be read.
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/timer.h"
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
    "Times one analysis and factorization of each mesh's V x V cotangent Laplacian, and the floor "
    "of\n"
    "any circle pattern: reading, one factorization of the F x F dual Laplacian, writing.\n\n";

using Time = ReferenceFactorization (*)(const Surface&);

ReferenceFactorization Fastest(Time time, const Surface& surface) {
  ReferenceFactorization best = time(surface);
  for (int i = 1; i < FLAGS_repeats; ++i) {
    const ReferenceFactorization again = time(surface);
    if (again.cpu_seconds < best.cpu_seconds) best = again;
  }
  return best;
}

Status TimeMesh(const std::string& path, const std::string& scratch) {
  const Timer reading;
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) return soup.status();
  const double read_seconds = reading.Seconds();
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  if (!surface.ok()) return surface.status().In(path);
  const ReferenceFactorization best = Fastest(TimeReferenceFactorization, *surface);
  const ReferenceFactorization dual = Fastest(TimeDualFactorization, *surface);
  const Timer writing;
  if (Status status = WriteMesh(scratch, *soup); !status.ok()) return status;
  const double floor = read_seconds + dual.seconds + writing.Seconds();
  std::cout << fmt::format(
      "{:<40} {:>9} triangles {:>9.4f} s wall {:>9.4f} s CPU, floor {:>9.4f} s wall\n", path,
      surface->triangulation.num_faces(), best.seconds, best.cpu_seconds, floor);
  return Status();
}

/// A file of this process, to be written for the time that takes.
class ScratchFile {
 public:
  ScratchFile()
      : path_((std::filesystem::temp_directory_path() /
               fmt::format("reference_factorization.{}.obj", getpid()))
                  .string()) {}
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

int Main(int argc, char** argv) {
  UseOneBlasThread();
  const StatusOr<std::vector<std::string>> meshes = ParseFlags(argc, argv, kSource);
  Status status = meshes.status();
  if (FLAGS_help) {
    std::cout << kUsage << FlagHelp(kSource);
    return 0;
  }
  if (status.ok() && meshes->empty()) status = Status::InvalidInput("no mesh given; see --help");
  const ScratchFile scratch;
  for (std::size_t i = 0; status.ok() && i < meshes->size(); ++i) {
    status = TimeMesh((*meshes)[i], scratch.path());
  }
  if (!status.ok()) std::cerr << "reference_factorization: " << status.message() << "\n";
  return ExitStatus(status.code());
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::Main(argc, argv); }
