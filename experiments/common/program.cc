#include "experiments/common/program.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include <glog/logging.h>

#include "cirque/linear/blas_threads.h"

#include "experiments/common/openblas.h"
#include "experiments/common/process.h"

namespace cirque {
namespace {

constexpr std::string_view kNoMemory =
    "out of memory: the mesh needs more than this process may have (ulimit -v, or the machine)";

void Say(std::string_view name, std::string_view what) {
  // No allocation: there may be no memory.
  for (const std::string_view part : {name, std::string_view(": "), what, std::string_view("\n")}) {
    if (write(STDERR_FILENO, part.data(), part.size()) < 0) return;
  }
}

void SayWhatWasThrown(std::string_view name) {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    Say(name, kNoMemory);
  } catch (const std::system_error& error) {
    // Of a reader that went away (`| head`) nothing is said.
    if (error.code() != std::errc::broken_pipe) Say(name, error.what());
  } catch (const std::exception& error) {
    Say(name, error.what());
  } catch (...) {
    Say(name, "an unknown exception");
  }
}

/// For exceptions that nobody can catch: thrown where none may be, or in a thread of a library.
[[noreturn]] void OnTerminate() {
  if (std::current_exception()) {
    SayWhatWasThrown(program_invocation_short_name);
    std::_Exit(kProgramFailed);
  }
  std::abort();
}

/// Puts something that cannot be written in the place of a stream that the parent has closed.
void OpenStandardStreams() {
  int file = 0;
  do {
    file = open("/dev/null", O_RDONLY);
  } while (file >= 0 && file <= STDERR_FILENO);
  if (file >= 0) close(file);
}

bool HasNoReader(int file) {
  pollfd state = {file, POLLOUT, 0};
  return poll(&state, 1, 0) == 1 && (state.revents & POLLERR);
}

/// Whether everything that was printed has been written.
bool Flush(std::string_view name) {
  errno = 0;
  std::cout.flush();
  const bool written = std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.good();
  if (!written && !HasNoReader(STDOUT_FILENO)) {
    // Where an earlier write failed, the stream is broken already, and another one tells why.
    if (errno == 0 && write(STDOUT_FILENO, "\n", 1) == 1) errno = EIO;
    Say(name, std::string("cannot write to standard output: ") + std::strerror(errno));
  }
  return written;
}

}  // namespace

int RunMain(std::string_view name, int argc, char** argv, int (*body)(int argc, char** argv)) {
  OpenStandardStreams();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGCHLD, SIG_DFL);
  std::set_terminate(OnTerminate);
  ForgetOpenBlasKernels();
  UseOneBlasThread();
  UseOneHeap();
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_ERROR;  // Ceres warns of what the summaries say
  google::InitGoogleLogging(argv[0]);
  try {
    const int status = body(argc, argv);
    return Flush(name) || status != 0 ? status : kProgramFailed;
  } catch (...) {
    SayWhatWasThrown(name);
  }
  // Libraries that were left in the middle of something are not asked to end in order.
  std::fflush(stdout);
  std::_Exit(kProgramFailed);
}

}  // namespace cirque
