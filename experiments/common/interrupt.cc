#include "experiments/common/interrupt.h"

#include <csignal>

namespace cirque {
namespace {

// A signal handler may touch lock-free atomics only.
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void OnSignal(int /*signal*/) { interrupted = true; }

}  // namespace

void CatchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = OnSignal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool IsInterrupted() { return interrupted; }

const std::atomic<bool>* InterruptFlag() { return &interrupted; }

}  // namespace cirque
