#include "experiments/run_experiment/results/provenance.h"

#include <archive.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <Eigen/Core>
#include <ceres/version.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#if __has_include(<suitesparse/SuiteSparse_config.h>)
#include <suitesparse/SuiteSparse_config.h>
#endif

#include "cirque/core/parallel.h"
#include "cirque/core/version.h"
#include "cirque/linear/blas_threads.h"

namespace cirque {
namespace {

std::string CpuModel() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string HostName() {
  char name[256] = {};
  return gethostname(name, sizeof(name) - 1) == 0 ? name : "unknown";
}

nlohmann::json Libraries() {
  nlohmann::json libraries = {
      {"ceres", CERES_VERSION_STRING},
      {"eigen",
       fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"fmt",
       fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"libarchive", archive_version_string()},
      {"blas", BlasName()},
  };
#ifdef SUITESPARSE_MAIN_VERSION
  libraries["suitesparse"] = fmt::format("{}.{}.{}", SUITESPARSE_MAIN_VERSION,
                                         SUITESPARSE_SUB_VERSION, SUITESPARSE_SUBSUB_VERSION);
#endif
  return libraries;
}

}  // namespace

nlohmann::json Provenance(const ExperimentConfig& config) {
#ifdef NDEBUG
  const char* build = "release";
#else
  const char* build = "debug";
#endif
  return {
      {"version", Version()},
      {"commit", GitCommit()},
      {"compiler", __VERSION__},
      {"build", build},
      {"libraries", Libraries()},
      {"cpu", CpuModel()},
      {"host", HostName()},
      {"cores", std::thread::hardware_concurrency()},
      {"blas_threads", NumBlasThreads()},
      {"threads", NumThreads()},
      {"config", config.name},
      {"question", config.question},
      {"config_hash", config.hash},
  };
}

std::string UtcNow() {
  const auto now =
      std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace cirque
