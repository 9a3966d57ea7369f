#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/energy/dual_laplacian.h"
#include "cirque/energy/edge_block_assembler.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// Two triangles glued along all three edges, a sphere; a triangle of which two edges are glued to
/// each other, a cone; and a closed surface.
std::vector<Triangulation> Triangulations() {
  return {NumberEdges(3, {0, 1, 2, 0, 2, 1}, {3, 5, 4, 0, 2, 1}),
          NumberEdges(2, {0, 1, 1}, {kNone, 2, 1}), GeneratedSurface("torus", 60).triangulation,
          GeneratedSurface("flat_delaunay_patch", 100).triangulation};
}

Eigen::MatrixXd Full(const SparseMatrix& lower) {
  const SparseMatrix full = lower.selfadjointView<Eigen::Lower>();
  return Eigen::MatrixXd(full);
}

TEST(DualLaplacian, IsTheSumOverItsEdges) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(0.1, 2);
  for (const Triangulation& t : Triangulations()) {
    Eigen::VectorXd weight = Eigen::VectorXd::Constant(t.num_halfedges(), 7);
    LaplacianAssembler expected(t.num_faces(), t.num_edges());
    for (const Index h : t.edge_halfedge) {
      if (t.twin[h] == kNone) continue;
      weight[h] = weight[t.twin[h]] = value(random);
      expected.Add(Triangulation::Face(h), Triangulation::Face(t.twin[h]), weight[h]);
    }
    SparseMatrix lower, wanted;
    const DualLaplacian laplacian(t);
    laplacian.Assemble(weight, &lower);
    expected.Assemble(&wanted);
    EXPECT_LT((Full(lower) - Full(wanted)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(lower.nonZeros(), laplacian.pattern().nonZeros());
  }
}

TEST(EdgeBlockAssembler, IsADTimesATransposed) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(-1, 1);
  for (const Triangulation& t : Triangulations()) {
    const AngleConstraints constraints(t, FreeBoundaryTargets(t));
    const int rows = constraints.num_rows(), corners = t.num_halfedges();
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, corners), d(corners, corners), extra;
    d.setZero();
    extra = Eigen::MatrixXd::Zero(rows, rows);
    EdgeBlockAssembler matrix(constraints);
    for (Index h = 0; h < corners; ++h) {
      a(Triangulation::Face(h), h) += 1;
      if (constraints.VertexRow(h) != kNone) a(constraints.VertexRow(h), h) += 1;
      matrix.Add(h, h, d(h, h) = value(random));
      const Index g = t.twin[h];
      if (g == kNone || h % 2 == g % 2) continue;  // some couple, some do not
      d(h, g) = d(g, h) = h < g ? value(random) : d(g, h);
      matrix.Add(h, g, d(h, g));
    }
    for (int row = 0; row < rows; ++row) matrix.AddToDiagonal(row, extra(row, row) = row);
    SparseMatrix lower;
    matrix.Assemble(&lower);
    EXPECT_LT((Full(lower) - a * d * a.transpose() - extra).cwiseAbs().maxCoeff(), 1e-14 * rows);
    for (int j = 0; j < rows; ++j) EXPECT_EQ(lower.innerIndexPtr()[lower.outerIndexPtr()[j]], j);
  }
}

/// Random weights for every corner and, where `couples` says so, for pairs across edges.
template <class Couples>
void AddWeights(const AngleConstraints& constraints, const Couples& couples, std::mt19937 random,
                EdgeBlockAssembler* matrix) {
  const Triangulation& t = constraints.triangulation();
  std::uniform_real_distribution<double> value(-1, 1);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const double own = value(random), shared = value(random);
    matrix->Add(h, h, own);
    const Index g = t.twin[h];
    if (h > g || !couples(h)) continue;  // a boundary edge's twin is kNone
    matrix->Add(h, g, shared);
    matrix->Add(g, h, shared);
  }
  for (int row = 0; row < constraints.num_rows(); row += 3) matrix->AddToDiagonal(row, row + 0.1);
}

TEST(EdgeBlockAssembler, AssemblesAgainWhatItAssemblesAnew) {
  for (const Triangulation& t : Triangulations()) {
    const AngleConstraints constraints(t, FreeBoundaryTargets(t));
    EdgeBlockAssembler again(constraints);
    SparseMatrix lower;
    for (unsigned round = 0; round < 6; ++round) {
      // Twice all couple, twice every third, then none, then all.
      const auto couples = [&](Index h) {
        return round == 4 ? false : round / 2 != 1 || h % 3 == 0;
      };
      again.Clear();
      EdgeBlockAssembler anew(constraints);
      for (EdgeBlockAssembler* matrix : {&again, &anew}) {
        AddWeights(constraints, couples, std::mt19937(round), matrix);
      }
      SparseMatrix expected;
      anew.Assemble(&expected);
      again.AssembleAgain(&lower);
      ASSERT_EQ(lower.nonZeros(), expected.nonZeros());
      for (int k = 0; k < lower.nonZeros(); ++k) {
        EXPECT_EQ(lower.innerIndexPtr()[k], expected.innerIndexPtr()[k]);
        EXPECT_EQ(lower.valuePtr()[k], expected.valuePtr()[k]) << "to the last bit";
      }
    }
  }
}

}  // namespace
}  // namespace cirque
