#include "experiments/run_experiment/run/child_process.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include <fmt/format.h>

namespace cirque {
namespace {

constexpr int kCannotExec = 127;

/// Files in memory: whatever a child prints, nobody has to be there to read it.
int MakeMemoryFile() { return memfd_create("run_experiment", MFD_CLOEXEC); }

std::string ReadMemoryFile(int file) {
  std::string content;
  char block[1 << 16];
  ssize_t size = 0;
  while ((size = pread(file, block, sizeof(block), static_cast<off_t>(content.size()))) > 0) {
    content.append(block, static_cast<std::size_t>(size));
  }
  return content;
}

bool WriteInput(int file, const std::string& input) {
  return write(file, input.data(), input.size()) == static_cast<ssize_t>(input.size()) &&
         lseek(file, 0, SEEK_SET) == 0;
}

std::vector<std::string> ChildEnvironment() {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) variables.push_back(*variable);
  for (const char* name : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "CIRQUE_NUM_THREADS"}) {
    if (std::getenv(name) == nullptr) variables.push_back(std::string(name) + "=1");
  }
  return variables;
}

std::vector<char*> Pointers(std::vector<std::string>* texts) {
  std::vector<char*> pointers;
  for (std::string& text : *texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

struct Streams {
  int input, output, errors;
};

double SecondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Of one process now [MiB]; 0 where there is none.
double ResidentMibOf(pid_t pid) {
  std::ifstream statm(fmt::format("/proc/{}/statm", pid));
  double size = 0, resident = 0;
  if (!(statm >> size >> resident)) return 0;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// Whether a fork of this process has not become another program yet.
bool IsStillThisProgram(pid_t pid) {
  std::error_code error;
  const auto own = std::filesystem::read_symlink("/proc/self/exe", error);
  return std::filesystem::read_symlink(fmt::format("/proc/{}/exe", pid), error) == own;
}

/// The same with all that it has started and what these have; `depth` bounds the way down.
double FamilyMib(pid_t pid, int depth) {
  double sum = ResidentMibOf(pid);
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", pid));
  for (pid_t child; depth > 0 && children >> child;) sum += FamilyMib(child, depth - 1);
  return sum;
}

constexpr int kDeepestFamily = 8;

/// Between fork and exec: system calls only.
[[noreturn]] void BecomeProgram(char* const* arguments, char* const* environment, pid_t parent,
                                const Streams& streams, bool own_group) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (own_group) setpgid(0, 0);
  if (getppid() != parent) _exit(kCannotExec);
  signal(SIGINT, SIG_IGN);
  signal(SIGTERM, SIG_IGN);
  dup2(streams.input, STDIN_FILENO);
  dup2(streams.output, STDOUT_FILENO);
  dup2(streams.errors, STDERR_FILENO);
  execve(arguments[0], arguments, environment);
  _exit(kCannotExec);
}

}  // namespace

StatusOr<ChildProcess> ChildProcess::Start(const std::vector<std::string>& command,
                                           const std::string& input, Kin kin) {
  std::vector<std::string> arguments = command, environment = ChildEnvironment();
  const std::vector<char*> argv = Pointers(&arguments), envp = Pointers(&environment);
  ChildProcess child;
  child.kin_ = kin;
  child.output_ = MakeMemoryFile();
  child.errors_ = MakeMemoryFile();
  const int input_file = MakeMemoryFile();
  const bool ready = child.output_ >= 0 && child.errors_ >= 0 && WriteInput(input_file, input);
  const pid_t parent = getpid();
  if (ready) child.pid_ = fork();
  if (child.pid_ == 0) {
    BecomeProgram(argv.data(), envp.data(), parent, {input_file, child.output_, child.errors_},
                  kin == Kin::kWithOwnChildren);
  }
  const int error = errno;
  if (input_file >= 0) close(input_file);
  if (child.pid_ > 0) return child;
  return Status::InvalidInput(
      fmt::format("{}: cannot start a process: {}", command[0], std::strerror(error)));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept { *this = std::move(other); }

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(status_, other.status_);
  std::swap(usage_, other.usage_);
  std::swap(kin_, other.kin_);
  std::swap(output_, other.output_);
  std::swap(errors_, other.errors_);
  std::swap(timer_, other.timer_);
  return *this;
}

ChildProcess::~ChildProcess() {
  Kill();
  for (const int file : {output_, errors_}) {
    if (file >= 0) close(file);
  }
}

bool ChildProcess::HasEnded() {
  if (pid_ <= 0) return true;
  const pid_t ended = wait4(pid_, &status_, WNOHANG, &usage_);
  // Of a child that was reaped elsewhere nothing but its output tells.
  if (ended == pid_ || (ended < 0 && errno == ECHILD)) pid_ = -1;
  return pid_ <= 0;
}

void ChildProcess::Kill() {
  if (pid_ <= 0) return;
  if (kin_ == Kin::kWithOwnChildren) kill(-pid_, SIGKILL);  // no such group yet: it is alone
  kill(pid_, SIGKILL);
  while (wait4(pid_, &status_, 0, &usage_) < 0 && errno == EINTR) {
  }
  pid_ = -1;
}

double ChildProcess::ResidentMib() const {
  if (pid_ <= 0) return 0;
  if (kin_ == Kin::kAlone) return ResidentMibOf(pid_);
  return IsStillThisProgram(pid_) ? 0 : FamilyMib(pid_, kDeepestFamily);
}

double ChildProcess::CpuSeconds() const {
  return SecondsOf(usage_.ru_utime) + SecondsOf(usage_.ru_stime);
}

double ChildProcess::PeakMib() const { return static_cast<double>(usage_.ru_maxrss) / 1024; }

bool ChildProcess::WasKilled() const {
  return WIFSIGNALED(status_) && (WTERMSIG(status_) == SIGKILL || WTERMSIG(status_) == SIGTERM);
}

bool ChildProcess::Succeeded() const { return WIFEXITED(status_) && WEXITSTATUS(status_) == 0; }

std::string ChildProcess::HowItEnded() const {
  if (WIFEXITED(status_)) return fmt::format("exit status {}", WEXITSTATUS(status_));
  const int signal = WTERMSIG(status_);
  return fmt::format("signal {} ({})", signal, strsignal(signal));
}

std::string ChildProcess::Output() const { return ReadMemoryFile(output_); }
std::string ChildProcess::Errors() const { return ReadMemoryFile(errors_); }

}  // namespace cirque
