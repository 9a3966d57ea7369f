#pragma once

#include <atomic>
#include <string>
#include <vector>

namespace cirque {

/// Makes all threads allocate from one heap, where the C library is glibc. Its default, a heap for
/// every thread, keeps what one thread has freed from the others: on large meshes a twentieth of
/// the peak. Our threads allocate little while they run, so nothing waits.
void UseOneHeap();

/// For a run that takes at most some 200 MiB: the heap begins on huge pages, and what is freed stays in
/// it. Faults of pages take up to a tenth of such a run otherwise. (More would be kept of a large one
/// than it may have.)
void KeepSmallHeap();

/// From here on the first Ctrl-C (or SIGTERM) asks to stop. Where that has not been heard within
/// kInterruptSeconds, as in a long factorization, or at a second signal, the process ends as it is,
/// with the exit status of kCancelled: files are written whole or not at all (core/atomic_file.h).
void CatchInterrupts();

constexpr double kInterruptSeconds = 0.5;

bool IsInterrupted();

/// The same as a flag for SolveControl::cancelled.
const std::atomic<bool>* InterruptFlag();

/// The largest resident memory this process has had since it began to run its program [MiB].
/// (getrusage would count the parent's.)
double PeakMemoryMib();

/// CPU time of all threads of this process [s].
double ProcessCpuSeconds();

/// Runs a program, found in PATH unless its name has a slash, with our own streams, and waits for it:
/// its exit status, or -1 where it could not be started or did not end by itself.
int RunAndWait(std::vector<std::string> words);

}  // namespace cirque
