// The quadratic fit written out: its matrices agree with one another and with hand-made blocks.
#include "cirque/angles/angle_program.h"

#include <cstdlib>
#include <utility>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Vector = Eigen::VectorXd;

class AngleProgramTest : public testing::Test {
 protected:
  AngleProgramTest() { std::srand(11); }

  static ConeTargets Ranged(const Triangulation& t) {
    ConeTargets targets = FreeBoundaryTargets(t);
    const std::vector<bool> boundary = BoundaryVertices(t);
    for (Index v = 0; v < t.num_vertices; ++v) {
      if (boundary[v]) targets.lower[v] = 0.4 * kPi, targets.upper[v] = 1.2 * kPi;
    }
    return targets;
  }

  Vector RandomX() const { return Vector::Random(program_.num_variables()); }
  Vector RandomY() const { return Vector::Random(constraints_.num_rows()); }
  Vector RandomZ() const { return Vector::Random(program_.num_inequalities()); }

  /// D = diag(w) + G' diag(q) G from the program's own products.
  Vector ApplyD(const Vector& q, const Vector& x) const {
    return program_.weight().cwiseProduct(x) +
           program_.ApplyTransposedG(q.cwiseProduct(program_.ApplyG(x)));
  }

  const Surface surface_ = GeneratedSurface("bumpy_terrain", 60);
  const Triangulation& t_ = surface_.triangulation;
  const AngleConstraints constraints_{t_, Ranged(t_)};
  const CornerAngles reference_ = AnglesOf(surface_);
  const AngleProgram program_{{constraints_, reference_.value, 1e-2},
                              **AngleObjectives().Find("weighted_quadratic")};
};

TEST_F(AngleProgramTest, HasAVariableMoreForEveryRangedVertex) {
  const auto ranged = static_cast<int>(BoundaryLoops(t_).front().size());
  EXPECT_EQ(program_.num_variables(), t_.num_halfedges() + ranged);
  // One bound a corner, one an edge, two a range.
  EXPECT_EQ(program_.num_inequalities(), t_.num_halfedges() + t_.num_edges() + 2 * ranged);
  EXPECT_EQ(program_.weight().tail(ranged).lpNorm<Eigen::Infinity>(), 0);
  EXPECT_GT(program_.weight().head(t_.num_halfedges()).minCoeff(), 0);
}

TEST_F(AngleProgramTest, TransposesAreAdjoint) {
  for (int i = 0; i < 5; ++i) {
    const Vector x = RandomX(), y = RandomY(), z = RandomZ();
    EXPECT_NEAR(program_.ApplyB(x).dot(y), x.dot(program_.ApplyTransposedB(y)), 1e-11);
    EXPECT_NEAR(program_.ApplyG(x).dot(z), x.dot(program_.ApplyTransposedG(z)), 1e-11);
  }
}

TEST_F(AngleProgramTest, ResidualsAndSlacksAreAffine) {
  const Vector x = RandomX(), step = RandomX();
  EXPECT_LT(
      (program_.EqualityResidual(x + step) - program_.EqualityResidual(x) - program_.ApplyB(step))
          .lpNorm<Eigen::Infinity>(),
      1e-12);
  EXPECT_LT((program_.Slacks(x + step) - program_.Slacks(x) - program_.ApplyG(step))
                .lpNorm<Eigen::Infinity>(),
            1e-12);
  // Of the surface's own angles, triangle sums are met and every angle is its own slack.
  Vector own = program_.centre();
  own.head(t_.num_halfedges()) = reference_.value;
  EXPECT_LT(program_.EqualityResidual(own).head(t_.num_faces()).lpNorm<Eigen::Infinity>(), 1e-13);
}

TEST_F(AngleProgramTest, IsLinearisedWithTheObjectivesOwnDerivatives) {
  for (const char* name : {"quadratic", "entropy"}) {
    const auto objective = *AngleObjectives().Find(name);
    AngleProgram program({constraints_, reference_.value, 1e-2}, *objective);
    const Vector x = program.InteriorPoint();
    Vector step = Vector::Random(x.size()) * 1e-6;
    step.tail(x.size() - t_.num_halfedges()).setZero();
    const auto at = [&](double length) {
      program.Linearize(x + length * step);
      return std::pair(program.value(), program.slope());
    };
    const auto [plus, slope_plus] = at(1);
    const auto [minus, slope_minus] = at(-1);
    program.Linearize(x);
    EXPECT_NEAR(plus - minus, 2 * program.slope().dot(step), 1e-13);
    const Vector bend = 2 * program.weight().cwiseProduct(step);
    EXPECT_LT((slope_plus - slope_minus - bend).lpNorm<Eigen::Infinity>(), 1e-12);
    EXPECT_GT(bend.lpNorm<Eigen::Infinity>(), 1e-7);
  }
}

TEST_F(AngleProgramTest, TheInteriorPointIsInside) {
  EXPECT_GT(program_.Slacks(program_.InteriorPoint()).minCoeff(), 1e-2);
}

TEST_F(AngleProgramTest, BlocksInvertD) {
  for (const double spread : {1.0, 1e12}) {
    const Vector q = (spread * RandomZ().cwiseAbs2()).array() + 1e-3;
    const AngleProgram::Blocks blocks(program_, q);
    const Vector v = RandomX();
    const Vector solution = blocks.Solve(v);
    EXPECT_LT((ApplyD(q, solution) - v).lpNorm<Eigen::Infinity>(), spread < 2 ? 1e-12 : 1e-3);
    const Vector direct = program_.ApplyG(solution);
    EXPECT_LT((blocks.ApplyGToSolution(v, blocks.Solve(v)) - direct).lpNorm<Eigen::Infinity>(),
              1e-12 * (1 + direct.lpNorm<Eigen::Infinity>()));
  }
}

TEST_F(AngleProgramTest, TheNormalMatrixIsBDInverseBTransposed) {
  const Vector q = RandomZ().cwiseAbs().array() + 0.1;
  const AngleProgram::Blocks blocks(program_, q);
  EdgeBlockAssembler assembler(constraints_);
  SparseMatrix lower;
  blocks.NormalMatrix(&assembler, &lower);
  const Eigen::MatrixXd normal = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  for (int i = 0; i < 4; ++i) {
    const Vector y = RandomY();
    const Vector expected = program_.ApplyB(blocks.Solve(program_.ApplyTransposedB(y)));
    EXPECT_LT((normal * y - expected).lpNorm<Eigen::Infinity>(), 1e-11);
  }
  EXPECT_GT(normal.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0);
}

}  // namespace
}  // namespace cirque
