#pragma once

#include <string>

namespace cirque {

/// Lets BLAS use one thread, unless OPENBLAS_NUM_THREADS asks for more, and so CHOLMOD's loops
/// round it, unless OMP_NUM_THREADS does: the matrices of a sparse factorization are small, a
/// second thread gains little on an idle machine and loses much where jobs run side by side.
void UseOneBlasThread();

/// CIRQUE_NUM_THREADS, the most threads of our own loops (core/parallel.h); 0, all cores, without
/// it.
int ThreadsByEnvironment();

/// The number of threads that BLAS uses; 0 where that cannot be known.
int NumBlasThreads();

/// OpenBLAS' own description of itself, "OpenBLAS 0.3.21 ..."; "unknown" for another BLAS.
std::string BlasName();

}  // namespace cirque
