// Certificates that the solvers return: sound, tight, and false ones rejected.
#include "cirque/angles/infeasibility.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "cirque/angles/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// The vertices and triangles of a terrain, every triangle with a vertex of valence 3 inside.
class CertificateOf : public testing::TestWithParam<std::string> {
 protected:
  CertificateOf() {
    const CornerAngles reference = AnglesOf(surface_);
    const Status status =
        FitAngles({constraints_, reference.value, 1e-3}, *AngleObjectives().Find("quadratic"),
                  **MakeAngleSolver(GetParam()), {}, &fit_);
    EXPECT_EQ(status.code(), StatusCode::kInfeasible) << status.message();
    EXPECT_NE(status.message().find("infeasibility certificate"), std::string::npos);
  }

  bool Holds(const InfeasibilityCertificate& certificate) const {
    return HoldsExactly(t_, certificate);
  }
  const InfeasibilityCertificate& certificate() const { return fit_.infeasibility; }

  const Surface surface_ = Kleetope(GeneratedSurface("bumpy_terrain", 80));
  const Triangulation& t_ = surface_.triangulation;
  const AngleConstraints constraints_{t_, FreeBoundaryTargets(t_)};
  AngleFitResult fit_;
};

TEST_P(CertificateOf, HoldsExactlyAndInDoublesWrittenOut) {
  ASSERT_TRUE(Holds(certificate()));
  // sum_f y_f + sum_v y_v s_v against the largest (A'y)_e . a of every edge.
  std::vector<double> of_vertex(t_.num_vertices, 0);
  double left = 0, right = 0;
  for (const double y : certificate().face_multiplier) left += y;
  for (std::size_t i = 0; i < certificate().vertex_multiplier.size(); ++i) {
    const double y = certificate().vertex_multiplier[i];
    of_vertex[certificate().constrained_vertex[i]] = y;
    left += 2 * y;  // every vertex inside is to be flat
  }
  const auto slope = [&](Index h) {
    return certificate().face_multiplier[h / 3] + of_vertex[t_.vertex[h]];
  };
  for (const Index l : t_.edge_halfedge) {
    const double q = t_.twin[l] == kNone ? 0 : slope(t_.twin[l]);
    right += std::max({0.0, slope(l), q});
  }
  EXPECT_EQ(certificate().epsilon_over_pi, 0);
  EXPECT_GE(left, right - 1e-10);
  EXPECT_GT(right, 1e-3);  // something is certified
  EXPECT_NEAR(certificate().margin, left - right, 1e-10);
}

TEST_P(CertificateOf, NamesCarriersOfTheLargestMultipliers) {
  double largest = 0;
  for (const double y : certificate().vertex_multiplier) largest = std::max(largest, std::abs(y));
  ASSERT_FALSE(certificate().carrying_vertices.empty());
  const auto& ids = certificate().constrained_vertex;
  const auto first = std::find(ids.begin(), ids.end(), certificate().carrying_vertices.front());
  ASSERT_NE(first, ids.end());
  EXPECT_EQ(std::abs(certificate().vertex_multiplier[first - ids.begin()]), largest);
}

TEST_P(CertificateOf, IsHomogeneousInItsMultipliers) {
  for (const double scale : {std::ldexp(1, -40), 8.0}) {
    InfeasibilityCertificate scaled = certificate();
    for (double& y : scaled.face_multiplier) y *= scale;
    for (double& y : scaled.vertex_multiplier) y *= scale;
    EXPECT_TRUE(Holds(scaled)) << scale;
  }
}

TEST_P(CertificateOf, PlantedFalseOnesAreRejected) {
  InfeasibilityCertificate wrong = certificate();
  for (double& y : wrong.face_multiplier) y = -y;
  for (double& y : wrong.vertex_multiplier) y = -y;
  EXPECT_FALSE(Holds(wrong)) << "all signs";
  wrong = certificate();
  for (double& y : wrong.vertex_multiplier) y = -y;
  EXPECT_FALSE(Holds(wrong)) << "the vertices' signs";
  wrong = certificate();
  wrong.face_multiplier[3] += 10 * (1 + wrong.margin);
  wrong.face_multiplier[4] -= 10 * (1 + wrong.margin);
  EXPECT_FALSE(Holds(wrong)) << "one triangle against another";
  wrong = certificate();
  wrong.vertex_multiplier.pop_back();
  EXPECT_FALSE(Holds(wrong)) << "a multiplier is missing";
  wrong = certificate();
  wrong.epsilon_over_pi = -1e-3;
  EXPECT_FALSE(Holds(wrong)) << "a negative margin";
  wrong = certificate();
  wrong.lower_over_pi.assign(wrong.lower_over_pi.size(), 0.01);
  EXPECT_FALSE(Holds(wrong)) << "the vertices may be cones of any small angle";
}

TEST_P(CertificateOf, SaysNothingAboutATriangulationThatHasCoherentAngles) {
  // The same multipliers on the terrain's own triangles, as many as fit.
  const Triangulation terrain = GeneratedSurface("bumpy_terrain", 80).triangulation;
  InfeasibilityCertificate other = certificate();
  other.face_multiplier.resize(terrain.num_faces());
  EXPECT_FALSE(HoldsExactly(terrain, InfeasibilityCertificate()));
  other.constrained_vertex.clear();
  other.vertex_multiplier.clear();
  other.lower_over_pi.clear();
  other.upper_over_pi.clear();
  EXPECT_FALSE(HoldsExactly(terrain, other));
}

INSTANTIATE_TEST_SUITE_P(Registry, CertificateOf, testing::ValuesIn(AngleSolvers().Names()),
                         [](const auto& of_case) { return of_case.param; });

TEST(InfeasibilityMargin, IsHomogeneousAndFallsWithLessRoom) {
  const Surface kleetope = Kleetope(GeneratedSurface("bumpy_terrain", 80));
  const AngleConstraints constraints(kleetope.triangulation,
                                     FreeBoundaryTargets(kleetope.triangulation));
  std::srand(3);
  for (int i = 0; i < 5; ++i) {
    const Eigen::VectorXd y = Eigen::VectorXd::Random(constraints.num_rows());
    const double margin = InfeasibilityMargin(constraints, 1e-3, y);
    EXPECT_NEAR(InfeasibilityMargin(constraints, 1e-3, 4 * y), 4 * margin, 1e-10);
    // Q_e shrinks as epsilon grows, so that the largest values on it fall and the margin rises.
    EXPECT_GT(InfeasibilityMargin(constraints, 1e-2, y), margin);
    EXPECT_LT(InfeasibilityMargin(constraints, 0, y), margin);
  }
}

TEST(InfeasibilityWatch, FindsNothingWhereNothingRunsOff) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 100);
  const AngleConstraints constraints(surface.triangulation,
                                     FreeBoundaryTargets(surface.triangulation));
  InfeasibilityWatch watch(constraints, 1e-3);
  std::srand(7);
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(watch.Found(std::pow(10., i) * Eigen::VectorXd::Random(constraints.num_rows())));
  }
  EXPECT_TRUE(watch.certificate().empty());
}

TEST(InfeasibilityWatch, FindsTheDirectionOfALastStepAndKeepsIt) {
  // Vertex 1 of the fan has two corners and must reach more than 2 pi.
  const Surface fan = Fan(6, 0.5);
  ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
  targets.lower[1] = targets.upper[1] = 2.2 * kPi;
  const AngleConstraints constraints(fan.triangulation, targets);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(constraints.num_rows()), step = y;
  step[fan.triangulation.num_faces() + 1] = 1;
  y[0] = 5;  // hides it
  InfeasibilityWatch watch(constraints, 1e-3), without_inequalities(constraints, -1);
  EXPECT_FALSE(watch.Found(y));
  EXPECT_TRUE(watch.Found(y + step));
  EXPECT_TRUE(HoldsExactly(fan.triangulation, watch.certificate()));
  EXPECT_TRUE(watch.Found(y));  // once found, it stays
  EXPECT_FALSE(without_inequalities.Found(step));
}

}  // namespace
}  // namespace cirque
