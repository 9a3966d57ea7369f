#pragma once

#include <atomic>

namespace cirque {

/// From here on the first Ctrl-C (or SIGTERM) only asks to stop; a second one ends the process.
void CatchInterrupts();

bool IsInterrupted();

/// The same as a flag for SolveControl::cancelled.
const std::atomic<bool>* InterruptFlag();

}  // namespace cirque
