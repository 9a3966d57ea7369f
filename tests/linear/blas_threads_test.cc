#include "cirque/linear/blas_threads.h"

#include <cstdlib>

#include <gtest/gtest.h>

extern "C" int omp_get_max_active_levels() __attribute__((weak));
extern "C" void omp_set_max_active_levels(int) __attribute__((weak));

namespace cirque {
namespace {

TEST(BlasThreads, OneThreadAskedForKeepsCholmodsOwnLoopsToOne) {
  if (!omp_get_max_active_levels) GTEST_SKIP() << "nothing here uses OpenMP";
  const int before = omp_get_max_active_levels();
  for (const char* threads : {"1", "2"}) {
    omp_set_max_active_levels(1);
    setenv("OMP_NUM_THREADS", threads, 1);
    UseOneBlasThread();
    EXPECT_EQ(omp_get_max_active_levels(), threads[0] == '1' ? 0 : 1) << threads;
  }
  setenv("OMP_NUM_THREADS", "1", 1);
  omp_set_max_active_levels(before);
}

}  // namespace
}  // namespace cirque
