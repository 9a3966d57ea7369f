// How tightly inexact Newton has its linear systems solved.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/linear/lagged_factorization.h"
#include "cirque/linear/registry.h"

#include "tests/solver/strategy_fixtures.h"

namespace cirque {
namespace {

/// Solves exactly and keeps what was asked for.
class RecordingSolver final : public SystemSolver {
 public:
  bool Solve(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
             const SolveAccuracy& accuracy, Eigen::VectorXd* x, SolveSummary* summary) override {
    asked.push_back(accuracy);
    return factor_.Solve(lower, right_side, accuracy, x, summary);
  }

  std::vector<SolveAccuracy> asked;

 private:
  LaggedFactorization factor_{MakeCholesky(), 10};
};

TEST(InexactNewton, NeverSolvesLooserThanForcingNorPastTheGoal) {
  const WallEnergy energy(0.3, 0.05, 1e-3);
  for (const char* forcing : {"1e-8", "0.5"}) {
    SCOPED_TRACE(forcing);
    RecordingSolver solver;
    SolveControl control;
    control.system_solver = &solver;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(1);
    const auto strategy = Strategy("newton_cg", {{"forcing", forcing}});
    EXPECT_TRUE(strategy->Minimize(energy, control, &x).Converged());
    ASSERT_GT(solver.asked.size(), 2u);
    for (const SolveAccuracy& accuracy : solver.asked) {
      EXPECT_LE(accuracy.tolerance, std::stod(forcing));
      EXPECT_GE(accuracy.tolerance, std::min(std::stod(forcing), 0.1 * accuracy.goal));
      EXPECT_GT(accuracy.tolerance, 0);
    }
  }
}

}  // namespace
}  // namespace cirque
