#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace cirque {

/// A figure that nothing has filled in.
inline constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

/// Why a solve ended, and what became of the caller's x.
enum class Termination {
  kNotRun,     ///< x untouched
  kConverged,  ///< the gradient test was met: x is the solution
  kStalled,  ///< no step improves x in floating point, the gradient test is not met: x is the best
             ///< iterate
  kIterationLimit,   ///< x is the last iterate
  kTimeLimit,        ///< x is the last iterate
  kStoppedByCaller,  ///< the callback asked to stop: x is the last iterate
  kCancelled,        ///< the cancellation flag was raised: x is the last iterate
  kInvalidStart,     ///< the start lies outside the energy's domain: x untouched
  kUnsupported,      ///< the energy does not offer the form that the strategy needs: x untouched
};

/// "converged", "stalled", ...: the word used in records and tables.
std::string ToString(Termination termination);

/// One accepted iterate.
struct IterationRecord {
  int iteration = 0;
  double value = kUnset;         ///< NaN where the strategy did not need it
  double gradient_max = kUnset;  ///< max |dE/dx_i|
  double step_length = kUnset;   ///< fraction of the proposed step that was taken
  double seconds = 0;            ///< since the start of the solve
};

/// What a solve did. Numbers keep their sentinels until the solve sets them.
struct SolveSummary {
  Termination termination = Termination::kNotRun;
  std::string message = "the solver was not called";
  std::string strategy;  ///< name, and the reason where it was chosen automatically

  double initial_value = kUnset, final_value = kUnset;
  double initial_gradient_max = kUnset, final_gradient_max = kUnset;
  int value_evaluations = 0, gradient_evaluations = 0, hessian_evaluations = 0;
  int symbolic_analyses = 0, factorizations = 0, linear_solves = 0, cg_iterations = 0;
  double total_seconds = 0, evaluation_seconds = 0, factorization_seconds = 0, solve_seconds = 0;
  bool x_changed = false;
  std::vector<IterationRecord> iterations;

  bool Converged() const { return termination == Termination::kConverged; }
  int num_iterations() const { return static_cast<int>(iterations.size()); }
  std::string BriefReport() const;  ///< one line
  std::string FullReport() const;   ///< a line per quantity, then a line per iteration
};

/// What a callback wants of the solve that called it.
enum class CallbackAction { kContinue, kStop };

/// Called after every accepted iterate with that iterate.
using IterationCallback =
    std::function<CallbackAction(const IterationRecord&, const Eigen::VectorXd& x)>;

class SystemSolver;

/// How a caller watches a solve, ends it early and helps it; shared by all strategies.
struct SolveControl {
  IterationCallback callback;                    ///< may be empty
  const std::atomic<bool>* cancelled = nullptr;  ///< may be null; polled at every iterate
  /// May be null. Has solved with a matrix near the Hessian at the start (SolverStrategy's
  /// MakeSystemSolver), for strategies that solve their systems iteratively.
  SystemSolver* system_solver = nullptr;
  /// May be empty. Told by whoever solves in stages which one begins: "angles", "radii", "layout".
  std::function<void(std::string_view stage)> on_stage = {};

  void BeginStage(std::string_view stage) const {
    if (on_stage) on_stage(stage);
  }
};

/// Wall-clock seconds since construction.
class Timer {
 public:
  double Seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace cirque
