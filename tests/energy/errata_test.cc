// framework/docs/errata.md in numbers: where the thesis's formula is wrong, and that ours is not.
#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/energy/coherent_angle_barrier.h"
#include "cirque/energy/lorentz_energy.h"
#include "cirque/math/circle_angle.h"
#include "cirque/math/moebius.h"

#include "experiments/audit_energies/samples.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// E's slope along p by a central difference.
double Slope(const Energy& energy, const VectorXd& x, const VectorXd& p, double h = 1e-5) {
  double plus = 0, minus = 0;
  const VectorXd ahead = x + h * p, behind = x - h * p;
  EXPECT_TRUE(energy.Evaluate(ahead.data(), &plus, nullptr));
  EXPECT_TRUE(energy.Evaluate(behind.data(), &minus, nullptr));
  return (plus - minus) / (2 * h);
}

VectorXd GradientOf(const Energy& energy, const VectorXd& x) {
  VectorXd gradient(x.size());
  EXPECT_TRUE(energy.Gradient(x.data(), gradient.data()));
  return gradient;
}

/// Two triangles of one edge: what the barrier's formulas are about.
class Errata : public ::testing::Test {
 protected:
  Errata() : disk_(audit_energies::DiskInput(1)) {
    for (const Index h : t().edge_halfedge) {
      if (t().twin[h] != kNone) inner_ = h;
    }
    x_ = audit_energies::RoundAngles(t(), 8);
    disk_.reference.value = audit_energies::RoundAngles(t(), 9);
  }

  const Triangulation& t() const { return disk_.triangulation; }
  CoherentAngleBarrier Barrier() const { return {t(), disk_.reference, 1e-3}; }

  /// dE/dalpha_l at the inner edge, with whatever stands for theta and its reference.
  double BarrierSlope(double theta, double theta_reference) const {
    const double a = x_[inner_], a0 = disk_.reference.value[inner_];
    return (1 / a0 - 1 / a) - (1 / theta_reference - 1 / theta);
  }

  EnergyInput disk_;
  Index inner_ = kNone;  ///< a halfedge with a twin
  VectorXd x_;
};

TEST_F(Errata, Item1BarrierDenominatorIsTheOppositeCornersReference) {
  // Read as the same corner twice, the denominator is no intersection angle: the reference itself
  // is then not where the energy is least.
  const Index g = t().twin[inner_];
  const VectorXd& ref = disk_.reference.value;
  const double theta0 = kPi - ref[inner_] - ref[g], printed = kPi - 2 * ref[inner_];
  ASSERT_GT(std::abs(theta0 - printed), 1e-3);
  x_ = ref;
  EXPECT_NEAR(BarrierSlope(theta0, theta0), 0, 1e-13);
  EXPECT_GT(std::abs(BarrierSlope(theta0, printed)), 1e-3);
  EXPECT_LT(GradientOf(Barrier(), ref).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST_F(Errata, Item2BarrierGradientNeedsTheReferenceAngles) {
  const Index g = t().twin[inner_];
  const VectorXd& ref = disk_.reference.value;
  const double theta = kPi - x_[inner_] - x_[g], theta0 = kPi - ref[inner_] - ref[g];
  const double difference = Slope(Barrier(), x_, VectorXd::Unit(x_.size(), inner_));
  EXPECT_NEAR(BarrierSlope(theta, theta0), difference, 1e-8);
  EXPECT_GT(std::abs(BarrierSlope(theta, theta) - difference), 1e-3);
  EXPECT_NEAR(GradientOf(Barrier(), x_)[inner_], difference, 1e-8);
}

TEST_F(Errata, Item3BarrierIsUndefinedForReferencesThatAreNotDelaunay) {
  disk_.reference.value = audit_energies::PairedAngles(t(), 2);
  const double theta0 = kPi - 2 * 2.0;
  EXPECT_TRUE(std::isnan(std::log(1.0 / theta0)));
  // Printed: theta / theta0 rewards large theta without bound. Clamped: convex, defined, counted.
  const CoherentAngleBarrier barrier = Barrier();
  EXPECT_GT(barrier.num_clamped(), 0);
  double value = std::nan("");
  EXPECT_TRUE(barrier.Evaluate(x_.data(), &value, nullptr));
  EXPECT_GT(value, 0);
}

TEST_F(Errata, Item4EveryNonPositiveAngleIsOutside) {
  const CoherentAngleBarrier barrier = Barrier();
  double value;
  for (const double angle : {0.0, -1e-9, -1.0}) {
    VectorXd x = x_;
    x[inner_] = angle;
    EXPECT_FALSE(barrier.Evaluate(x.data(), &value, nullptr)) << angle;
  }
  // The gradient's 1/a0 - 1/a is a plain number again beyond zero.
  EXPECT_TRUE(std::isfinite(1 / disk_.reference.value[inner_] - 1 / -1.0));
}

TEST_F(Errata, Item6LorentzEnergyLacksTheSquareRoot) {
  const Vector3d v = Vector3d(1, 2, -2) / 3, x(0.3, -0.2, 0.4);
  const auto printed = [&](const Vector3d& at) {
    return std::log((1 - v.dot(at)) / (1 - at.squaredNorm()));
  };
  const Vector3d gradient = LorentzElement(v, x).slope;
  // The printed gradient, which is ours.
  const Vector3d as_printed = x / (1 - x.squaredNorm()) - v / (1 - v.dot(x));
  EXPECT_LT((gradient - as_printed).norm(), 1e-15);
  for (int k = 0; k < 3; ++k) {
    const Vector3d h = 1e-5 * Vector3d::Unit(k);
    const double ours = (LorentzElement(v, x + h).value - LorentzElement(v, x - h).value) / 2e-5;
    EXPECT_NEAR(ours, gradient[k], 1e-9);
    EXPECT_GT(std::abs((printed(x + h) - printed(x - h)) / 2e-5 - gradient[k]), 0.1);
  }
}

TEST_F(Errata, Item7LorentzTransformNeedsScalingAndDivision) {
  const Vector3d v = Vector3d(1, 2, -2) / 3, x(0.3, -0.2, 0.4);
  const double x4 = 1 / std::sqrt(1 - x.squaredNorm());
  const auto moved = [&](const Vector3d& s) -> Vector3d {
    return v + (v.dot(s) / (x4 + 1) - 1) * s;
  };
  const Vector3d right = moved(x4 * x) / (x4 - v.dot(x4 * x));
  EXPECT_NEAR(right.norm(), 1, 1e-14);
  EXPECT_LT((right - LorentzBoost(x)(v)).norm(), 1e-14);
  EXPECT_GT(std::abs(moved(x).norm() - 1), 0.01);       // not scaled: no point of the sphere
  EXPECT_GT(std::abs(moved(x4 * x).norm() - 1), 0.01);  // scaled, not divided: neither
}

TEST_F(Errata, Item13GaussBonnetHoldsForAngleDefects) {
  for (const char* generator : {"bumpy_terrain", "sphere", "annulus"}) {
    const Surface surface = GeneratedSurface(generator, 100);
    const Triangulation& t = surface.triangulation;
    const CornerAngles alpha = AnglesOf(surface);
    const std::vector<bool> boundary = BoundaryVertices(t);
    double curvature = 0;
    for (Index v = 0; v < t.num_vertices; ++v) curvature += boundary[v] ? kPi : 2 * kPi;
    curvature -= alpha.value.sum();
    EXPECT_NEAR(curvature, 2 * kPi * EulerCharacteristic(t), 1e-10) << generator;
  }
}

TEST_F(Errata, Item14RowsOfTheConstraintMatrix) {
  const AngleConstraints constraints(t(), FreeBoundaryTargets(t()));
  for (Index h = 0; h < t().num_halfedges(); ++h) {
    const VectorXd column = constraints.Apply(VectorXd::Unit(t().num_halfedges(), h));
    VectorXd expected = VectorXd::Unit(column.size(), Triangulation::Face(h));
    if (constraints.VertexRow(h) != kNone) expected[constraints.VertexRow(h)] = 1;
    EXPECT_EQ(column, expected);
  }
}

TEST_F(Errata, Item15QuadraticObjectiveIsASumOverCorners) {
  const auto objective = *AngleObjectives().Find("quadratic");
  const VectorXd& ref = disk_.reference.value;
  double sum = 0;
  for (const Index h : t().edge_halfedge) {
    const Index g = t().twin[h];
    sum += g == kNone ? objective->Boundary(ref[h], 1e-3, x_[h])
                      : objective->Interior(ref[h], ref[g], 1e-3, x_[h], x_[g]);
  }
  EXPECT_NEAR(sum, 0.5 * (x_ - ref).squaredNorm(), 1e-13);
  EXPECT_GT(sum, 0.1);
}

TEST_F(Errata, Item16FreeBoundaryVerticesHaveNoRow) {
  const AngleConstraints constraints(t(), FreeBoundaryTargets(t()));
  const std::vector<bool> boundary = BoundaryVertices(t());
  int interior = 0;
  for (Index v = 0; v < t().num_vertices; ++v) interior += !boundary[v];
  ASSERT_GT(interior, 0);
  EXPECT_EQ(constraints.num_rows(), t().num_faces() + interior);
  for (int row = t().num_faces(); row < constraints.num_rows(); ++row) {
    EXPECT_EQ(constraints.Lower(row), 2 * kPi);
    EXPECT_EQ(constraints.Upper(row), 2 * kPi);
  }
}

TEST_F(Errata, Item17BoundaryTermOfThePatternGradientIsTwice) {
  const CirclePatternEnergy energy(t(), disk_.coherent);
  const VectorXd rho = audit_energies::Random(3).Vector(t().num_faces(), 1);
  const VectorXd ours = GradientOf(energy, rho);
  VectorXd printed = ours;
  for (const Index h : t().edge_halfedge) {
    if (t().twin[h] == kNone) printed[Triangulation::Face(h)] += disk_.coherent.value[h];
  }
  // The scale of all radii changes nothing: only the gradient with the factor 2 knows that.
  EXPECT_NEAR(ours.sum(), 0, 1e-12);
  EXPECT_GT(std::abs(printed.sum()), 1);
  const VectorXd p = VectorXd::Unit(rho.size(), Triangulation::Face(t().edge_halfedge[0]));
  EXPECT_NEAR(Slope(energy, rho, p), ours.dot(p), 1e-8);
}

TEST_F(Errata, Item18ArctanMissesObtuseCorners) {
  // A flat triangle with an obtuse corner against a small one: phi_i is that corner.
  const double alpha_i = 2.0, alpha_j = 0.4, theta = kPi - alpha_i - alpha_j;
  const double d = std::log(std::sin(alpha_j) / std::sin(alpha_i));
  const double quotient = std::sin(theta) / (std::exp(d) - std::cos(theta));
  EXPECT_NEAR(HalfAngle(d, theta), alpha_i, 1e-14);
  EXPECT_NEAR(std::atan(quotient), alpha_i - kPi, 1e-14);
  // The other orientation of (i, j) is the other corner.
  EXPECT_NEAR(HalfAngle(-d, theta), alpha_j, 1e-14);
}

TEST_F(Errata, Item19FirstFormOfPhiHasTheWrongSignAndRadiiForLogarithms) {
  const double star = 2.1, r_i = 1.7, r_j = 0.6, d = std::log(r_i / r_j);
  const auto form = [&](double sign, double difference) {
    return star / 2 + sign * std::atan(std::tanh(difference / 2) * std::tan(star / 2));
  };
  const double phi = HalfAngle(d, kPi - star);
  EXPECT_NEAR(form(-1, d), phi, 1e-14);
  EXPECT_GT(std::abs(form(+1, d) - phi), 0.1);
  EXPECT_GT(std::abs(form(-1, r_i - r_j) - phi), 0.01);
  // A larger circle sees the edge under a smaller angle.
  EXPECT_LT(phi, HalfAngle(-d, kPi - star));
}

TEST_F(Errata, Item20PatternHessianIsSingularWithoutAGauge) {
  const CirclePatternEnergy energy(t(), disk_.coherent);
  const VectorXd rho = audit_energies::Random(3).Vector(t().num_faces(), 1);
  SparseMatrix lower;
  ASSERT_TRUE(energy.Hessian(rho.data(), &lower));
  const Eigen::MatrixXd hessian = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  EXPECT_LT((hessian * VectorXd::Ones(rho.size())).lpNorm<Eigen::Infinity>(), 1e-12);
  const auto n = rho.size() - 1;
  EXPECT_EQ(energy.GaugeParameters(), std::vector<int>{0});
  EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(hessian.bottomRightCorner(n, n)).info(), Eigen::Success);
}

}  // namespace
}  // namespace cirque
