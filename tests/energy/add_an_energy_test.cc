// Follows framework/docs/adding-an-energy.md: an energy, an objective and a strategy, each in one file pair
// and one line of a table, are audited and used like the framework's own.
#include <gtest/gtest.h>

#include "cirque/angles/angle_fit.h"
#include "cirque/angles/registry.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/audit_energies/audit.h"
#include "experiments/audit_energies/samples.h"
#include "tests/common/surfaces.h"
#include "tests/energy/example/cosh_objective.h"
#include "tests/energy/example/gradient_descent_strategy.h"
#include "tests/energy/example/spring_energy.h"

namespace cirque {
namespace {

using audit_energies::AuditSamples;
using audit_energies::Reals;
using audit_energies::ReferenceValue;
using audit_energies::SampleCase;
using high_precision::Real;

const Registry<EnergyFactory>& MyEnergies() {
  static const Registry<EnergyFactory> kTable = Energies().With("spring", MakeSpring);
  return kTable;
}

/// Step 3 of the README: the definition in 50 digits.
ReferenceValue SpringReference(const EnergyInput& input, const Reals& x) {
  ReferenceValue sum;
  const Triangulation& t = input.triangulation;
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    if (g == kNone) continue;
    const Real rest = Real(input.reference.value[h]) - Real(input.reference.value[g]);
    const Real term = cosh(x[Triangulation::Face(h)] - x[Triangulation::Face(g)] - rest) - 1;
    sum.value += term;
    sum.magnitude += term;
  }
  return sum;
}

/// Step 3: where to audit.
AuditSamples SpringSamples() {
  SampleCase c{"disk", std::make_shared<const EnergyInput>(audit_energies::DiskInput(1)), {}, {}};
  const int n = c.input->triangulation.num_faces();
  audit_energies::Random random(1);
  c.inside = {{"near", random.Vector(n, 1), 0.05}, {"stretched", random.Vector(n, 8), 0.05}};
  return {{c}, SpringReference};
}

TEST(AddAnEnergy, ItPassesTheAudit) {
  const Registry<audit_energies::SampleMaker> samples("samples", {{"spring", SpringSamples}});
  const Registry<EnergyFactory> spring("energy", {{"spring", *MyEnergies().Find("spring")}});
  const auto rows = audit_energies::AuditRegistry(spring, samples);
  ASSERT_EQ(rows.size(), 1u);
  ASSERT_TRUE(rows[0].status.ok()) << rows[0].status.message();
  EXPECT_EQ(MyEnergies().Names().size(), Energies().Names().size() + 1);
  for (const auto& f : rows[0].findings) {
    EXPECT_TRUE(f.ok()) << f.check << " " << f.figure << " at " << f.where;
  }
}

TEST(AddAnEnergy, NewtonMinimisesIt) {
  const EnergyInput input = audit_energies::DiskInput(1);
  const auto energy = (*MyEnergies().Find("spring"))(input);
  Eigen::VectorXd x = audit_energies::Random(2).Vector(energy->NumParameters(), 3);
  const double gauge = x[0];
  const SolveSummary summary = (*MakeSolverStrategy("newton"))->Minimize(*energy, {}, &x);
  EXPECT_TRUE(summary.Converged()) << summary.FullReport();
  EXPECT_LT(summary.final_value, 0.5 * summary.initial_value);
  EXPECT_NEAR(x[0], gauge, 1e-14);
}

TEST(AddAnObjective, ItIsFittedByTheDualLikeAnyOther) {
  const Registry<std::shared_ptr<const AngleObjective>> objectives(
      "angle objective", {{"cosh", std::make_shared<CoshObjective>()}});
  const Surface surface = GeneratedSurface("bumpy_terrain", 200);
  const AngleConstraints constraints(surface.triangulation,
                                     FreeBoundaryTargets(surface.triangulation));
  const CornerAngles reference = AnglesOf(surface);
  const auto fit_with = [&](const std::shared_ptr<const AngleObjective>& objective) {
    AngleFitResult fit;
    const Status status = FitAngles({constraints, reference.value, 1e-3}, objective,
                                    **MakeAngleSolver("newton"), {}, &fit);
    EXPECT_TRUE(status.ok()) << status.message();
    return fit.angles.value;
  };
  const Eigen::VectorXd cosh = fit_with(*objectives.Find("cosh"));
  const Eigen::VectorXd quadratic = fit_with(*AngleObjectives().Find("quadratic"));
  const CoshObjective objective;
  const auto cost = [&](const Eigen::VectorXd& alpha) {
    double sum = 0;
    for (int h = 0; h < alpha.size(); ++h) {
      sum += objective.Distance(reference.value[h], alpha[h]).value;
    }
    return sum;
  };
  // Each objective's own minimiser is the better one under it; both are coherent.
  EXPECT_LT(cost(cosh), cost(quadratic));
  EXPECT_LT((constraints.Apply(cosh) - constraints.Apply(quadratic)).lpNorm<Eigen::Infinity>(),
            1e-9);
  EXPECT_GT((cosh - quadratic).lpNorm<Eigen::Infinity>(), 1e-5);
}

TEST(AddAStrategy, ItMinimisesWhatNewtonDoes) {
  const Registry<SolverStrategyFactory> strategies(
      "solver strategy",
      {{"gradient_descent", FactoryOf<GradientDescentStrategy>(GradientDescentOptionTable())}});
  const EnergyInput input = audit_energies::DiskInput(1);
  const auto energy = MakeSpring(input);
  const auto descent =
      (*strategies.Find("gradient_descent"))({{"gradient_tolerance", "1e-9"}, {"step", "0.1"}});
  ASSERT_TRUE(descent.ok()) << descent.status().message();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(energy->NumParameters()), y = x;
  EXPECT_TRUE((*descent)->Minimize(*energy, {}, &x).Converged());
  EXPECT_TRUE((*MakeSolverStrategy("newton"))->Minimize(*energy, {}, &y).Converged());
  EXPECT_LT(((x.array() - x[0]) - (y.array() - y[0])).abs().maxCoeff(), 1e-7);
  EXPECT_FALSE((*strategies.Find("gradient_descent"))({{"step", "-1"}}).ok());
}

}  // namespace
}  // namespace cirque
