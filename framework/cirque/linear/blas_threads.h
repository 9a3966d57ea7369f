#pragma once

#include <string>

namespace cirque {

/// Lets BLAS use one thread, unless OPENBLAS_NUM_THREADS asks for more, and so CHOLMOD's loops
/// round it, unless OMP_NUM_THREADS does: the matrices of a sparse factorization are small, a
/// second thread gains little on an idle machine and loses much where jobs run side by side.
void UseOneBlasThread();

/// The same while it lives, and then as it was before: for a library among others in a process.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  int blas_threads_, active_levels_;
};

/// Takes the buffers that OpenBLAS needs for calls from `threads` threads at once (0: as many as
/// there are cores) where the address space is limited: it waits for ever for one that it cannot
/// have. Returns for how many there was room, `threads` where nothing is limited.
/// Throws std::bad_alloc where there is not even room for one.
int ReserveBlasBuffers(int threads);

/// CIRQUE_NUM_THREADS, the most threads of our own loops (core/parallel.h); 0, all cores, without
/// it.
int ThreadsByEnvironment();

/// The number of threads that BLAS uses; 0 where that cannot be known.
int NumBlasThreads();

/// OpenBLAS' own description of itself, "OpenBLAS 0.3.21 ..."; "unknown" for another BLAS.
std::string BlasName();

}  // namespace cirque
