#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <string>
#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"

namespace cirque {

/// A program as a child of this process: reads `input`, and keeps what it prints. It ends with this
/// process, however that ends; what asks this process to stop (Ctrl-C, SIGTERM to all processes of
/// a cluster's job) it ignores. BLAS and our own loops use one thread in it unless the environment
/// says otherwise.
class ChildProcess {
 public:
  /// Whether what the program starts itself is measured, and killed, with it.
  enum class Kin { kAlone, kWithOwnChildren };

  /// `command[0]` is the path of the program.
  static StatusOr<ChildProcess> Start(const std::vector<std::string>& command,
                                      const std::string& input, Kin kin = Kin::kAlone);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  ~ChildProcess();  ///< ends it if it still runs

  /// Whether it has ended; does not wait.
  bool HasEnded();
  void Kill();

  double Seconds() const { return timer_.Seconds(); }  ///< since its start
  double ResidentMib() const;                          ///< now; 0 where it has ended

  /// Once it has ended: of it and those of its children that it waited for. The peak is of the largest
  /// of these processes, and not below what this process had at the start.
  double CpuSeconds() const;
  double PeakMib() const;

  /// Once it has ended: whether it ended by itself with status 0, or was killed, and how it ended,
  /// for a message.
  bool Succeeded() const;
  bool WasKilled() const;  ///< by SIGKILL
  std::string HowItEnded() const;

  std::string Output() const;  ///< what it has printed so far
  std::string Errors() const;

 private:
  ChildProcess() = default;

  pid_t pid_ = -1;  ///< -1 once it has ended
  int status_ = 0;  ///< of wait4
  rusage usage_ = {};
  Kin kin_ = Kin::kAlone;
  int output_ = -1, errors_ = -1;
  Timer timer_;
};

}  // namespace cirque
