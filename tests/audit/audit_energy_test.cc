// The auditor judged on energies of two parameters, whose faults are known by construction.
#include "cirque/audit/audit_energy.h"

#include <cmath>
#include <functional>

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/audit/checks.h"

namespace cirque {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using testing::ElementsAre;
using testing::IsEmpty;

/// E = cosh(x - y) + x^4 on |x| < 10, with what a test replaces of it.
class Bowl : public Energy {
 public:
  int NumParameters() const override { return 2; }

  bool Evaluate(const double* p, double* value, double* gradient) const override {
    if (!AllFinite(p) || std::abs(p[0]) >= 10) return false;
    const double d = p[0] - p[1];
    *value = std::cosh(d) + std::pow(p[0], 4);
    if (gradient) {
      gradient[0] = std::sinh(d) + slope_of_quartic * std::pow(p[0], 3);
      gradient[1] = -std::sinh(d);
    }
    return true;
  }

  bool Hessian(const double* p, SparseMatrix* lower) const override {
    if (!AllFinite(p) || std::abs(p[0]) >= 10) return false;
    const double c = std::cosh(p[0] - p[1]);
    Matrix2d h;
    h << c + 12 * p[0] * p[0], 0, coupling * c, c;
    *lower = h.sparseView();
    return true;
  }

  bool IsConvex() const override { return claims_convexity; }

  double slope_of_quartic = 4, coupling = -1;
  bool claims_convexity = true;
};

std::vector<std::string> Failed(const Bowl& bowl) {
  AuditCase c{"bowl", std::make_shared<Bowl>(bowl), {}, {}};
  c.inside = {{"bottom", Vector2d(0.1, 0.05), 0.1}, {"slope", Vector2d(1.5, -2), 0.1}};
  c.outside = {{"beyond", Vector2d(10, 0)}};
  std::vector<std::string> failed;
  for (const AuditFinding& f : AuditEnergy({c})) {
    if (!f.ok()) failed.push_back(f.check);
  }
  return failed;
}

TEST(AuditEnergy, ASoundEnergyOfAUserPasses) { EXPECT_THAT(Failed({}), IsEmpty()); }

TEST(AuditEnergy, AWrongFactorInTheGradientIsSeen) {
  Bowl bowl;
  bowl.slope_of_quartic = 3.99;
  EXPECT_THAT(Failed(bowl), testing::Contains("gradient"));
}

TEST(AuditEnergy, AWrongSignInTheHessianIsSeenByDerivativesAlone) {
  Bowl bowl;
  bowl.coupling = 1;
  EXPECT_THAT(Failed(bowl), ElementsAre("hessian"));
}

TEST(AuditEnergy, AnIndefiniteHessianIsNoConvexity) {
  Bowl bowl;
  bowl.coupling = -30;
  EXPECT_THAT(Failed(bowl), ElementsAre("hessian", "convexity"));
  bowl.claims_convexity = false;
  EXPECT_THAT(Failed(bowl), ElementsAre("hessian"));
}

TEST(AuditEnergy, EveryCheckLooksAtSomething) {
  AuditCase c{"bowl", std::make_shared<Bowl>(), {{"here", Vector2d(1, 2), 0.1}}, {}};
  const std::vector<AuditFinding> findings = AuditEnergy({c});
  ASSERT_EQ(findings.size(), AuditChecks().size());
  for (const AuditFinding& f : findings) EXPECT_THAT(f.where, testing::StartsWith("bowl, "));
}

TEST(AuditEnergy, TakesChecksOfTheCallers) {
  const AuditCheck value_at_bottom = {"bottom", 1e-12, [](const AuditCase& c, AuditFinding* f) {
                                        f->Note(ValueAt(*c.energy, Vector2d::Zero()) - 1, "0");
                                      }};
  const AuditCase c{"bowl", std::make_shared<Bowl>(), {}, {}};
  const std::vector<AuditFinding> findings = AuditEnergy({c}, {value_at_bottom});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_TRUE(findings[0].ok());
  EXPECT_EQ(findings[0].where, "0");
}

TEST(AuditFinding, KeepsTheWorstAndNanAboveAll) {
  AuditFinding finding;
  finding.Note(1, "first");
  finding.Note(0.5, "better");
  EXPECT_EQ(finding.where, "first");
  finding.Note(std::nan(""), "nan");
  finding.Note(1e300, "large");
  EXPECT_EQ(finding.where, "nan");
  EXPECT_FALSE(finding.ok());
}

TEST(AuditProbes, GiveWhatTheEnergyGivesAndNanWhereItRefuses) {
  const Bowl bowl;
  const Vector2d at(0.5, 1), outside(11, 0);
  EXPECT_DOUBLE_EQ(ValueAt(bowl, at), std::cosh(0.5) + 0.0625);
  EXPECT_DOUBLE_EQ(GradientAt(bowl, at)[1], std::sinh(0.5));
  const Eigen::MatrixXd h = HessianAt(bowl, at);
  EXPECT_EQ(h(0, 1), h(1, 0));
  EXPECT_TRUE(std::isnan(ValueAt(bowl, outside)));
  EXPECT_TRUE(GradientAt(bowl, outside).hasNaN());
  EXPECT_TRUE(HessianAt(bowl, outside).hasNaN());
}

TEST(AuditProbes, DirectionsAreOfLargestEntryOneAndSpan) {
  for (const int n : {1, 2, 6, 40}) {
    const auto directions = Directions(n);
    Eigen::MatrixXd all(n, directions.size());
    for (std::size_t k = 0; k < directions.size(); ++k) {
      EXPECT_DOUBLE_EQ(directions[k].lpNorm<Eigen::Infinity>(), 1);
      all.col(k) = directions[k];
    }
    EXPECT_EQ(all.fullPivLu().rank(), std::min<int>(n, directions.size()));
  }
}

}  // namespace
}  // namespace cirque
