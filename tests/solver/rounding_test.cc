// Second-order methods end where the gradient is rounding, however near to the end they began.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/solver/strategy_fixtures.h"

namespace cirque {
namespace {

using testing::HasSubstr;

/// |x|^2 / 2, whose gradient is known to 5e-11 only.
class CoarseQuadratic final : public Energy {
 public:
  int NumParameters() const override { return 4; }
  bool Evaluate(const double* x, double* value, double* gradient) const override {
    *value = 0;
    for (int i = 0; i < 4; ++i) {
      *value += 0.5 * x[i] * x[i];
      if (gradient) gradient[i] = x[i] + 5e-11 * std::cos(1e15 * x[i] + i);
    }
    return std::isfinite(*value);
  }
  bool Hessian(const double*, SparseMatrix* lower) const override {
    lower->resize(4, 4);
    lower->setIdentity();
    return true;
  }
};

TEST(Rounding, EndsSecondOrderMethodsFromNearAndFar) {
  for (const char* strategy : {"newton", "newton_cg", "auto"}) {
    for (const double start : {1e-6, 1e3}) {
      SCOPED_TRACE(testing::Message() << strategy << " from " << start);
      Eigen::VectorXd x = Eigen::VectorXd::Constant(4, start);
      const SolveSummary summary = Strategy(strategy)->Minimize(CoarseQuadratic(), {}, &x);
      EXPECT_THAT(summary.message, testing::AnyOf(HasSubstr("no longer falls"), HasSubstr("<=")));
      EXPECT_LT(x.lpNorm<Eigen::Infinity>(), 1e-9);
      EXPECT_GE(summary.num_iterations(), 1);
      EXPECT_LE(summary.num_iterations(), 12);
    }
  }
}

}  // namespace
}  // namespace cirque
