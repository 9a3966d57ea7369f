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

void UseOneBlasThread() {
  if (openblas_set_num_threads && !std::getenv("OPENBLAS_NUM_THREADS")) openblas_set_num_threads(1);
  if (omp_set_max_active_levels && !std::getenv("OMP_NUM_THREADS")) omp_set_max_active_levels(0);
}

int ThreadsByEnvironment() {
  const char* threads = std::getenv("CIRQUE_NUM_THREADS");
  return threads ? std::max(0, std::atoi(threads)) : 0;
}

int NumBlasThreads() { return openblas_get_num_threads ? openblas_get_num_threads() : 0; }

std::string BlasName() { return openblas_get_config ? openblas_get_config() : "unknown"; }

}  // namespace cirque
