#pragma once

#include <string>
#include <vector>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_problem.h"
#include "cirque/core/option_table.h"

namespace cirque {

/// A way to choose where cones lie and what their angle sums are (docs/mathematics.md, Cones).
class ConeHeuristic {
 public:
  virtual ~ConeHeuristic() = default;

  /// Cones at candidates of the problem, which with flat other vertices satisfy Gauss-Bonnet and
  /// whose angles the corners can reach; the same for the same problem. Errors (invalid input):
  /// the surface, or the file that was named, leaves no such cones; the message says what would.
  virtual StatusOr<std::vector<Cone>> Choose(const ConeProblem& problem) const = 0;
};

enum class LogScaleNorm { kL2, kMax };  ///< kL2: area-weighted

template <>
inline constexpr auto kEnumWords<LogScaleNorm> =
    std::to_array<EnumWord<LogScaleNorm>>({{LogScaleNorm::kL2, "l2"}, {LogScaleNorm::kMax, "max"}});

/// How many cones. The options of every heuristic that counts begin with these.
struct ConeBudget {
  int cones = -1;     ///< the most, but for what Gauss-Bonnet needs; -1: 8, or what `target` needs
  double target = 0;  ///< distortion in the linear model at which to stop; 0: use all cones
  LogScaleNorm norm = LogScaleNorm::kL2;  ///< of the log scale u for `target`
};

/// The rows of ConeBudget, for the table of a struct that derives from it.
template <class T>
std::vector<Option<T>> BudgetOptions() {
  return {
      Option<T>("cones", &T::cones,
                "the most cones, but for what Gauss-Bonnet needs; -1: 8, or what the target needs")
          .Between(-1, 1e6),
      Option<T>("target", &T::target, "log scale at which to stop; 0: none").Between(0, 1e6),
      Option<T>("norm", &T::norm, "of the log scale, for the target")};
}

/// A heuristic that can choose any number of cones: the base finds the least number that meets a
/// target, by doubling and bisection.
class BudgetedHeuristic : public ConeHeuristic {
 public:
  explicit BudgetedHeuristic(const ConeBudget& budget) : budget_(budget) {}

  /// When even the most cones miss the target, those are returned.
  StatusOr<std::vector<Cone>> Choose(const ConeProblem& problem) const final;

 protected:
  /// At most `count` cones; on a closed surface that needs more, as many as it needs.
  virtual StatusOr<std::vector<Cone>> ChooseAtMost(const ConeProblem& problem, int count) const = 0;

 private:
  bool MeetsTarget(const ConeProblem& problem, const StatusOr<std::vector<Cone>>& cones) const;

  ConeBudget budget_;
};

/// u of the linear model for cones at the middle of their intervals, V.
Eigen::VectorXd PredictedLogScale(const ConeProblem& problem, const std::vector<Cone>& cones);

}  // namespace cirque
