#include "experiments/common/blas_threads.h"

#include <algorithm>
#include <cstdlib>

// OpenBLAS' own functions, absent in other BLAS.
extern "C" {
void openblas_set_num_threads(int) __attribute__((weak));
int openblas_get_num_threads() __attribute__((weak));
char* openblas_get_config() __attribute__((weak));
}

// OpenMP's, absent where nothing uses it.
extern "C" void omp_set_max_active_levels(int) __attribute__((weak));

namespace cirque {

namespace {

/// Whether a variable of the environment asks for more than one thread.
bool AsksForThreads(const char* variable) {
  const char* threads = std::getenv(variable);
  return threads && std::atoi(threads) != 1;
}

}  // namespace

void UseOneBlasThread() {
  if (openblas_set_num_threads && !AsksForThreads("OPENBLAS_NUM_THREADS")) {
    openblas_set_num_threads(1);
  }
  // CHOLMOD asks for four threads by name, whatever OMP_NUM_THREADS says, unless none may be
  // nested.
  if (omp_set_max_active_levels && !AsksForThreads("OMP_NUM_THREADS")) omp_set_max_active_levels(0);
}

int ThreadsByEnvironment() {
  const char* threads = std::getenv("CIRQUE_NUM_THREADS");
  return threads ? std::max(0, std::atoi(threads)) : 0;
}

int NumBlasThreads() { return openblas_get_num_threads ? openblas_get_num_threads() : 0; }

std::string BlasName() { return openblas_get_config ? openblas_get_config() : "unknown"; }

}  // namespace cirque
