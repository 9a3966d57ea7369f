#include <vector>

#include <gtest/gtest.h>

#include "cirque/energy/dual_angle_energy.h"
#include "cirque/linear/registry.h"
#include "cirque/solver/newton_loop.h"

#include "tests/common/surfaces.h"
#include "tests/energy/relaxation_checks.h"

namespace cirque {
namespace {

using Eigen::VectorXd;

constexpr double kEps = 0.05;

/// The dual of the quadratic fit to these angles.
DualAngleEnergy Dual(const Triangulation& t, const ConeTargets& targets,
                     const VectorXd& reference) {
  return {AngleConstraints(t, targets), reference, kEps, *AngleObjectives().Find("quadratic")};
}

/// Newton's full step from 0.
EnergyPoint AfterNewtonStep(const Energy& energy) {
  const EnergyPoint start = PointAt(energy, VectorXd::Zero(energy.NumParameters()));
  SparseMatrix hessian;
  EXPECT_TRUE(energy.Hessian(start.x.data(), &hessian));
  const auto cholesky = MakeCholesky();
  LevenbergMarquardtDamping(energy).DampHessian(&hessian);
  EXPECT_TRUE(cholesky->Factorize(hessian));
  return PointAt(energy, -cholesky->Solve(start.gradient));
}

int NumDifferent(const VectorXd& a, const VectorXd& b) {
  return static_cast<int>((a.array() != b.array()).count());
}

class DualAngleRelaxation : public ::testing::Test {
 protected:
  const Surface surface_ = GeneratedSurface("bumpy_terrain", 2000);
  const Triangulation& t_ = surface_.triangulation;
  const CornerAngles reference_ = AnglesOf(surface_);
  const ConeTargets targets_ = FreeBoundaryTargets(t_);
  const DualAngleEnergy energy_ = Dual(t_, targets_, reference_.value);
};

TEST_F(DualAngleRelaxation, RemovesWhatNewtonsStepLeftWhereEdgesBecameActive) {
  const EnergyPoint before = AfterNewtonStep(energy_);
  ASSERT_GT(before.largest(), 1e-3) << "no edge became active";
  EnergyPoint after;
  ASSERT_TRUE(ExpectSoundRelax(energy_, 1e-3, before, &after));
  EXPECT_LE(after.largest(), before.largest() / 10);
  EXPECT_LT(after.value, before.value - 1e-6);
  EXPECT_LT(NumDifferent(after.x, before.x), 100) << "not local";
}

TEST_F(DualAngleRelaxation, BringsDisturbedMultipliersBack) {
  const EnergyPoint step = AfterNewtonStep(energy_);
  VectorXd x = step.x;
  x[700] += 0.3;   // a face
  x[2400] -= 0.2;  // a vertex
  const EnergyPoint before = PointAt(energy_, x);
  EnergyPoint after;
  ASSERT_TRUE(ExpectSoundRelax(energy_, 1e-3, before, &after));
  EXPECT_LE(after.largest(), before.largest() / 10);
  EXPECT_LT(after.value - step.value, 1e-2 * (before.value - step.value));
}

TEST_F(DualAngleRelaxation, IsLeftAloneWithARangedVertex) {
  const VectorXd x = AfterNewtonStep(energy_).x;
  ConeTargets ranged = targets_;
  Index inner = 0;
  while (!ranged.IsFixed(inner)) ++inner;
  ranged.lower[inner] -= 0.5;
  const DualAngleEnergy energy = Dual(t_, ranged, reference_.value);
  ASSERT_EQ(energy.NumParameters(), x.size());
  EnergyPoint after;
  EXPECT_FALSE(ExpectSoundRelax(energy, 1e-3, PointAt(energy, x), &after));
}

/// The targets that these angles meet, so that nothing but what is disturbed stands out.
ConeTargets SumsOf(const Triangulation& t, const VectorXd& angles) {
  std::vector<double> sums(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) sums[t.vertex[h]] += angles[h];
  return {sums, sums};
}

TEST(DualAngleRelaxationOfGluedFaces, KnowsWhichAnglesARowAddsUp) {
  const Surface torus = GeneratedSurface("torus", 400);
  const Triangulation t = WithFoldedFace(torus.triangulation, 100);
  VectorXd reference = VectorXd::Constant(t.num_halfedges(), kPi / 3);
  reference.head(torus.triangulation.num_halfedges()) = AnglesOf(torus).value;
  const DualAngleEnergy energy = Dual(t, SumsOf(t, reference), reference);
  const int faces = t.num_faces(), corner = t.num_halfedges() - 6;
  ASSERT_EQ(energy.NumParameters(), faces + t.num_vertices);
  // The faces that were put in, their vertices, and any other face.
  for (const int row : {faces - 2, faces - 1, faces + t.vertex[corner],
                        faces + t.vertex[corner + 1], faces + t.num_vertices - 1, 7}) {
    SCOPED_TRACE(row);
    VectorXd x = VectorXd::Zero(energy.NumParameters());
    x[row] = 0.3;
    const EnergyPoint before = PointAt(energy, x);
    EnergyPoint after;
    ASSERT_TRUE(ExpectSoundRelax(energy, 0.7, before, &after));
    EXPECT_LE(after.largest(), 0.7 * before.largest());
    EXPECT_LT(after.value, before.value - 1e-3);
  }
}

TEST(DualAngleRelaxationOfAFan, DoesNotThrowAMultiplierFarBeyondItsMinimum) {
  // All angles at the hub but one have just reached their upper bound, so that one alone makes the
  // slope of their sum. A Newton step for the whole excess takes all to their lower bounds: little
  // excess is left there, but the value is higher than at the start.
  const Surface fan = Fan(50, 0.1);
  const ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
  const CornerAngles reference = AnglesOf(fan);
  const DualAngleEnergy energy = Dual(fan.triangulation, targets, reference.value);
  const int hub = fan.triangulation.num_faces();
  ASSERT_EQ(energy.NumParameters(), hub + 1);
  VectorXd x = VectorXd::Zero(hub + 1);
  x[0] = -kPi;
  x[hub] = kPi;
  const EnergyPoint before = PointAt(energy, x);
  x[hub] -= before.gradient[hub];
  const EnergyPoint beyond = PointAt(energy, x);
  ASSERT_GT(before.gradient[hub], 100);
  ASSERT_NEAR(beyond.gradient[hub], 50 * kEps - 2 * kPi, 1e-9);
  ASSERT_GT(beyond.value, before.value + 100);
  EnergyPoint after;
  ExpectSoundRelax(energy, 0.5, before, &after);
}

}  // namespace
}  // namespace cirque
