// Preloaded into a program (LD_PRELOAD), makes its N-th call of one function of the system fail:
//   FAILING_CALL=malloc:N, write:N, fsync:N, wait:N (waitpid, wait4) or fork:N
//   FAILING_CALL_MARK=FILE   made when that call came
// Counts from when the program asks not to be killed by closed pipes, which every main does first
// (experiments/common/program.cc): what libraries do while they are loaded is not ours. glibc.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

extern "C" void* __libc_malloc(std::size_t);

namespace {

std::atomic<bool> counting = false;
std::atomic<long> calls = 0;

/// Whether this call of that function is the one to fail.
bool Fails(const char* function) {
  if (!counting) return false;
  const char* const wanted = std::getenv("FAILING_CALL");
  const std::size_t length = std::strlen(function);
  if (!wanted || std::strncmp(wanted, function, length) != 0 || wanted[length] != ':') return false;
  if (++calls != std::atol(wanted + length + 1)) return false;
  if (const char* const mark = std::getenv("FAILING_CALL_MARK")) {
    syscall(SYS_close, syscall(SYS_open, mark, O_CREAT | O_WRONLY, 0600));
  }
  return true;
}

template <class Function>
Function* Next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

void (*signal(int number, void (*handler)(int)) noexcept)(int) {
  if (number == SIGPIPE) counting = true;
  return Next<decltype(signal)>("signal")(number, handler);
}

void* malloc(std::size_t size) {
  if (Fails("malloc")) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_malloc(size);
}

ssize_t write(int file, const void* data, std::size_t size) {
  if (Fails("write")) {
    errno = ENOSPC;
    return -1;
  }
  return syscall(SYS_write, file, data, size);
}

int fsync(int file) {
  if (Fails("fsync")) {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fsync, file));
}

int fdatasync(int file) {
  if (Fails("fsync")) {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fdatasync, file));
}

pid_t wait4(pid_t child, int* status, int options, rusage* usage) noexcept {
  if (Fails("wait")) {
    errno = EINTR;
    return -1;
  }
  return static_cast<pid_t>(syscall(SYS_wait4, child, status, options, usage));
}

pid_t waitpid(pid_t child, int* status, int options) {
  return wait4(child, status, options, nullptr);
}

pid_t fork() noexcept {
  if (Fails("fork")) {
    errno = EAGAIN;
    return -1;
  }
  return Next<decltype(fork)>("fork")();
}

}  // extern "C"
