#pragma once

namespace cirque {

/// From here on the first Ctrl-C (or SIGTERM) only asks to stop; a second one ends the process.
void CatchInterrupts();

bool IsInterrupted();

}  // namespace cirque
