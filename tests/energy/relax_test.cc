// Energy::Relax of every registered energy: lowers the value, or does nothing and says so.
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/energy/registry.h"

#include "experiments/audit_energies/audit.h"
#include "experiments/audit_energies/samples.h"
#include "tests/common/surfaces.h"
#include "tests/energy/relaxation_checks.h"

namespace cirque {
namespace {

using Eigen::VectorXd;

/// Large enough that single parameters count as few; with what every energy takes.
EnergyInput LargeInput() {
  const Surface surface = GeneratedSurface("bumpy_terrain", 400);
  EnergyInput input = audit_energies::PointsInput(100, 3, 2);
  input.triangulation = surface.triangulation;
  input.reference = AnglesOf(surface);
  input.coherent.value = audit_energies::RoundAngles(surface.triangulation, 3);
  input.lengths = MeasureEdgeLengths(surface);
  input.targets = FreeBoundaryTargets(surface.triangulation);
  input.epsilon = 0.05;
  return input;
}

/// Points of which at least one lies in the domain of every energy of that input: near 0 and far
/// from it in all parameters, in few of them, and round triangles.
std::vector<VectorXd> Candidates(const EnergyInput& input, int n) {
  audit_energies::Random random(11);
  std::vector<VectorXd> points;
  for (int i = 0; i < 10; ++i) {
    for (const double size : {0.05, 1.0, 3.0, 10.0}) points.push_back(random.Vector(n, size));
    for (const double height : {0.3, 5.0, -5.0}) {
      points.push_back(VectorXd::Zero(n));
      points.back()[static_cast<int>(random.Uniform(0, n))] = height;
    }
  }
  if (n == input.triangulation.num_halfedges()) points.push_back(input.coherent.value);
  return points;
}

class EveryEnergyRelax : public ::testing::TestWithParam<std::string> {
 protected:
  void ExpectSound(const Energy& energy, const VectorXd& x) {
    for (const double share : {1e-3, 0.5, 0.9, 0.99}) {
      SCOPED_TRACE(share);
      EnergyPoint after;
      ExpectSoundRelax(energy, share, PointAt(energy, x), &after);
    }
  }
};

TEST_P(EveryEnergyRelax, LowersTheValueOrDoesNothing) {
  const EnergyInput input = LargeInput();
  const std::unique_ptr<Energy> energy = (*Energies().Find(GetParam()))(input);
  int num_inside = 0;
  for (const VectorXd& x : Candidates(input, energy->NumParameters())) {
    double value;
    if (!energy->Evaluate(x.data(), &value, nullptr)) continue;
    SCOPED_TRACE(testing::Message() << "point " << num_inside++);
    ExpectSound(*energy, x);
  }
  EXPECT_GT(num_inside, 0) << "give Candidates one for this energy";
}

TEST_P(EveryEnergyRelax, IsSoundWhereTheEnergyIsFragile) {
  const auto samples = audit_energies::Samples().Find(GetParam());
  ASSERT_TRUE(samples.ok()) << samples.status().message();
  for (const audit_energies::SampleCase& c : (*samples)().cases) {
    const std::unique_ptr<Energy> energy = (*Energies().Find(GetParam()))(*c.input);
    for (const AuditPoint& point : c.inside) {
      SCOPED_TRACE(c.name + ", " + point.name);
      ExpectSound(*energy, point.x);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryEnergyRelax, ::testing::ValuesIn(Energies().Names()));

}  // namespace
}  // namespace cirque
