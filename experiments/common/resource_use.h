#pragma once

namespace cirque {

/// The largest resident memory this process has had since it began to run its program [MiB].
/// (getrusage would count the parent's.)
double PeakMemoryMib();

/// CPU time of all threads of this process [s].
double ProcessCpuSeconds();

}  // namespace cirque
