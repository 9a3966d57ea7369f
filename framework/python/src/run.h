#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/map_arrays.h"

namespace cirque::python {

namespace py = pybind11;

/// A status on its way to Python, where it becomes an exception of the package (_errors.py).
struct StatusError : std::exception {
  Status status;
  MapFailure failure;

  explicit StatusError(Status of, MapFailure with = {})
      : status(std::move(of)), failure(std::move(with)) {}
  const char* what() const noexcept override { return status.message().c_str(); }
};

/// Makes StatusErrors Python's.
void TranslateStatusErrors();

/// Throws unless it is ok.
inline void Check(const Status& status) {
  if (!status.ok()) throw StatusError(status);
}

/// The value, or a StatusError.
template <class T>
T ValueOf(StatusOr<T> value, MapFailure failure = {}) {
  if (!value.ok()) throw StatusError(value.status(), std::move(failure));
  return *std::move(value);
}

/// One call from Python that may take long. The library works in a thread of its own without the
/// GIL, while the caller's looks for signals (Ctrl-C) twenty times a second: those, and exceptions of
/// Python functions that the library calls, cancel the work and are raised. The library sees that it
/// is cancelled at a solver's next iterate; a caller waits half a second for that, then leaves the
/// thread to itself, which ends unheard and is waited for before Python ends.
class Run {
 public:
  /// `progress`, unless None, is called as progress(stage, iteration, gradient, seconds) at every
  /// iterate; where it returns False the run is cancelled. `kept`: what the work looks at.
  static std::shared_ptr<Run> Make(py::object progress, py::object kept = py::none());

  /// Does the work, with the GIL held by the caller before and after, and returns what it returns.
  /// Throws what it throws. It owns what it uses, since it may be left behind.
  template <class Work>
  static auto Do(const std::shared_ptr<Run>& run, Work work) {
    using Result = decltype(work(SolveControl()));
    const auto result = std::make_shared<std::optional<Result>>();
    DoUnheard(run, [result, work = std::move(work)](const SolveControl& control) {
      result->emplace(work(control));
    });
    return *std::move(*result);
  }

  /// Calls a Python function from the library's side, with the GIL. False where it, or an earlier
  /// one, raised an exception; the run is then cancelled.
  bool Call(const std::function<void()>& function);

 private:
  Run(py::object progress, py::object kept)
      : progress_(std::move(progress)), kept_(std::move(kept)) {}

  using Work = std::function<void(const SolveControl&)>;
  static void DoUnheard(const std::shared_ptr<Run>& run, Work work);
  static void LeaveBehind(const std::shared_ptr<Run>& run);
  void DoInThread(const Work& work);
  bool WaitForEnd();
  void CheckSignals();
  SolveControl Control();
  void Keep(py::error_already_set&& error);

  py::object progress_, kept_;
  std::string stage_;
  std::atomic<bool> cancelled_ = false;
  std::atomic<bool> is_deaf_ = false;            ///< no more calls of Python
  std::optional<py::error_already_set> raised_;  ///< guarded by the GIL

  std::thread thread_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;  ///< guarded by the mutex, like the next
  std::exception_ptr thrown_;
};

}  // namespace cirque::python
