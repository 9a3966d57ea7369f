#include "experiments/common/openblas.h"

#include <algorithm>
#include <cstdlib>

namespace cirque {
namespace {

constexpr char kCoreType[] = "OPENBLAS_CORETYPE";

bool told_openblas = false;  // while it is loaded, before there are threads

/// The kernels that suit what the processor can do; null: the choice of OpenBLAS.
const char* SuitingKernels() {
#ifdef __x86_64__
  __builtin_cpu_init();
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
  if (__builtin_cpu_is("intel") && avx512) return "SkylakeX";
  if (__builtin_cpu_is("intel") && avx2) return "Haswell";
  if (__builtin_cpu_is("amd") && avx2) return "Zen";
#endif
  return nullptr;
}

}  // namespace

void ForgetOpenBlasKernels() {
  if (told_openblas) unsetenv(kCoreType);
  told_openblas = false;
}

}  // namespace cirque

// Defined in a program, these take the place of OpenBLAS' own, which it calls while it is loaded.

// Before it chooses its kernels. It knows processors by their numbers, and takes those that are newer than
// itself for the oldest, without vectors (0.3.21 an Emerald Rapids for a Prescott of 2004).
extern "C" void openblas_read_env() {
  const char* kernels = std::getenv(cirque::kCoreType) ? nullptr : cirque::SuitingKernels();
  if (kernels) cirque::told_openblas = setenv(cirque::kCoreType, kernels, 0) == 0;
}

// What it says of that.
extern "C" int openblas_verbose() {
  const char* level = std::getenv("OPENBLAS_VERBOSE");
  return level ? std::atoi(level) : 0;
}

// How many threads to make. They would spin beside a short run until it ends, and where the address
// space is limited (ulimit -v) end the program for want of room, or wait for ever for buffers that do
// not fit. 0 lets OpenBLAS decide.
extern "C" int openblas_num_threads_env() {
  const char* threads = std::getenv("OPENBLAS_NUM_THREADS");
  return threads ? std::max(0, std::atoi(threads)) : 1;
}
