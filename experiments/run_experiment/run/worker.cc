#include <cstdio>
#include <string>

#include <fmt/format.h>

#include "cirque/core/parallel.h"

#include "experiments/common/blas_threads.h"
#include "experiments/common/process.h"
#include "experiments/run_experiment/run/worker_pool.h"

namespace cirque {
namespace {

std::string ReadStandardInput() {
  std::string bytes;
  char block[1 << 12];
  while (const std::size_t size = std::fread(block, 1, sizeof(block), stdin)) {
    bytes.append(block, size);
  }
  return bytes;
}

}  // namespace

int RunWorker(const RunFunction& carry_out) {
  StatusOr<ReadyRun> ready = UnpackRun(ReadStandardInput());
  if (!ready.ok()) {
    fmt::print(stderr, "{}\n", ready.status().message());
    return 1;
  }
  const ThreadLimit limit(ThreadsByEnvironment());
  ready->provenance["blas_threads"] = NumBlasThreads();
  ready->provenance["threads"] = NumThreads();
  StatusOr<Record> record = CarryOut(*ready, carry_out);
  if (!record.ok()) {
    fmt::print(stderr, "{}\n", record.status().message());
    return 1;
  }
  if (!record->contains("peak_memory_mib")) (*record)["peak_memory_mib"] = PeakMemoryMib();
  fmt::print("{}\n", ToLine(*record));
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace cirque
