#include "experiments/common/process.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace cirque {
namespace {

#ifdef __GLIBC__

constexpr int kMiB = 1 << 20;
constexpr std::uintptr_t kHugePage = 2 * kMiB;

std::uintptr_t HeapEnd() { return reinterpret_cast<std::uintptr_t>(sbrk(0)); }

/// Lets the heap, in which allocations lie up to the largest, have that much more address space at once,
/// in huge pages where the system offers them. It takes memory as it is touched.
void GrowHeap(int bytes, int largest) {
  const std::uintptr_t before = HeapEnd();
  mallopt(M_TOP_PAD, bytes);
  // Nothing free has room for it. (Volatile, or a compiler leaves both calls out.)
  void* volatile first = std::malloc(largest - kMiB);
  std::free(first);
  mallopt(M_TOP_PAD, kMiB / 8);
  const std::uintptr_t begin = (before / kHugePage + 1) * kHugePage;
  const std::uintptr_t end = HeapEnd() / kHugePage * kHugePage;
  if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

#endif

}  // namespace

void UseOneHeap() {
#ifdef __GLIBC__
  mallopt(M_ARENA_MAX, 1);
#endif
}

void KeepSmallHeap() {
#ifdef __GLIBC__
  constexpr int kLargest = 4 * kMiB, kKept = 64 * kMiB;
  mallopt(M_MMAP_THRESHOLD, kLargest);
  mallopt(M_TRIM_THRESHOLD, kKept);
  GrowHeap(kKept, kLargest);
#endif
}

namespace {

constexpr int kCancelledStatus = 1;

// A signal handler may touch lock-free atomics only.
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

timer_t patience;  // set once, before the handlers

void OnLongWait(int /*signal*/) {
  constexpr char kMessage[] = "interrupted\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage, sizeof(kMessage) - 1);
  _exit(kCancelledStatus);
}

void OnSignal(int /*signal*/) {
  interrupted = true;
  const itimerspec wait = {{}, {0, static_cast<long>(1e9 * kInterruptSeconds)}};
  timer_settime(patience, 0, &wait, nullptr);
}

void Handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void CatchInterrupts() {
  sigevent event = {};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  if (timer_create(CLOCK_MONOTONIC, &event, &patience) != 0) return;  // signals end the process
  Handle(SIGALRM, OnLongWait, SA_RESTART);
  constexpr int kOnce = static_cast<int>(SA_RESETHAND | SA_RESTART);
  Handle(SIGINT, OnSignal, kOnce);
  Handle(SIGTERM, OnSignal, kOnce);
}

bool IsInterrupted() { return interrupted; }

const std::atomic<bool>* InterruptFlag() { return &interrupted; }

double PeakMemoryMib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  }
  return 0;
}

double ProcessCpuSeconds() {
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

int RunAndWait(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) {
    return -1;
  }
  int status = 0;
  if (waitpid(child, &status, 0) < 0 || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

}  // namespace cirque
