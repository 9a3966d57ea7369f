#include "experiments/common/blas_threads.h"

#include <dlfcn.h>

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

// The entry into a parallel region of libgomp, the OpenMP runtime of Debian's CHOLMOD.
extern "C" void GOMP_parallel(void (*region)(void*), void* data, unsigned num_threads,
                              unsigned flags);

namespace cirque {

namespace {

/// Whether a variable of the environment asks for more than one thread.
bool AsksForThreads(const char* variable) {
  const char* threads = std::getenv(variable);
  return threads && std::atoi(threads) != 1;
}

}  // namespace

}  // namespace cirque

// Defined in a program, it takes the place of libgomp's. That makes a team of threads for every
// region, even of one, with an allocation and a call of the system: CHOLMOD has four regions in
// every supernode, and a quarter of its numeric factorization went into their teams. Outside of any
// team a region is run by the thread that comes along.
void GOMP_parallel(void (*region)(void*), void* data, unsigned num_threads, unsigned flags) {
  using Enter = decltype(&GOMP_parallel);
  static const Enter kTeam = cirque::AsksForThreads("OMP_NUM_THREADS")
                                 ? reinterpret_cast<Enter>(dlsym(RTLD_NEXT, "GOMP_parallel"))
                                 : nullptr;
  if (kTeam) return kTeam(region, data, num_threads, flags);
  region(data);
}

namespace cirque {

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
