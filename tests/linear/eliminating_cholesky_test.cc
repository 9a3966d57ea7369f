#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/dual_angle_energy.h"
#include "cirque/linear/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// Hands everything to a dense factorization and tells how large the matrix was.
class DenseCholesky final : public SparseCholesky {
 public:
  explicit DenseCholesky(int* size) : size_(*size) {}
  void Solve(const Eigen::VectorXd& b, Eigen::VectorXd* x) override { *x = factor_.solve(b); }

 protected:
  bool Analyze(const SparseMatrix& lower) override {
    size_ = static_cast<int>(lower.cols());
    return true;
  }
  bool FactorizeNumerically(const SparseMatrix& lower) override {
    factor_.compute(Eigen::MatrixXd(lower));
    return factor_.info() == Eigen::Success;
  }

 private:
  int& size_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

double SolveError(const SparseMatrix& lower, SparseCholesky* cholesky) {
  const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(lower.cols(), -1, 2);
  const Eigen::VectorXd right_side = lower.selfadjointView<Eigen::Lower>() * wanted;
  if (!cholesky->Factorize(lower)) return 1e300;
  return (cholesky->Solve(right_side) - wanted).lpNorm<Eigen::Infinity>();
}

/// The dual Hessian of a terrain's angle fit at y = 0, made definite.
SparseMatrix AngleFitMatrix(const Surface& surface, double shift) {
  const CornerAngles reference = AnglesOf(surface);
  const Triangulation& t = surface.triangulation;
  const DualAngleEnergy energy(AngleConstraints(t, FreeBoundaryTargets(t)), reference.value, 1e-3,
                               *AngleObjectives().Find("quadratic"));
  SparseMatrix lower;
  EXPECT_TRUE(energy.Hessian(Eigen::VectorXd::Zero(energy.NumParameters()).eval().data(), &lower));
  for (int i = 0; i < lower.cols(); ++i) lower.coeffRef(i, i) += shift;
  return lower;
}

TEST(EliminatingCholesky, TrianglesWithoutActiveEdgesAreEliminated) {
  const Surface surface = GeneratedSurface("flat_delaunay_patch", 300);
  const SparseMatrix lower = AngleFitMatrix(surface, 1e-3);
  int size = -1;
  const auto cholesky = MakeEliminatingCholesky(std::make_unique<DenseCholesky>(&size));
  EXPECT_LT(SolveError(lower, cholesky.get()), 1e-9);
  EXPECT_GT(size, 0);
  EXPECT_LE(size, lower.cols() - surface.triangulation.num_faces());
}

TEST(EliminatingCholesky, NumericalChangesKeepTheAnalysis) {
  const Surface surface = GeneratedSurface("flat_delaunay_patch", 200);
  int size = -1;
  const auto cholesky = MakeEliminatingCholesky(std::make_unique<DenseCholesky>(&size));
  for (const double shift : {1e-3, 1., 50.}) {
    EXPECT_LT(SolveError(AngleFitMatrix(surface, shift), cholesky.get()), 1e-9);
  }
  EXPECT_EQ(cholesky->symbolic_analyses(), 1);
  EXPECT_EQ(cholesky->factorizations(), 3);
}

/// Tells which order it was advised to take.
class AdvisedCholesky final : public SparseCholesky {
 public:
  explicit AdvisedCholesky(std::vector<int>* advice)
      : advice_(*advice), inner_((*LinearSolvers().Find("eigen"))()) {}
  void Solve(const Eigen::VectorXd& b, Eigen::VectorXd* x) override { inner_->Solve(b, x); }
  std::vector<int> Ordering() const override { return order_; }
  void SuggestOrdering(std::vector<int> order) override { advice_ = std::move(order); }

 protected:
  bool Analyze(const SparseMatrix& lower) override {
    order_.resize(lower.cols());
    std::iota(order_.rbegin(), order_.rend(), 0);  // backwards
    return true;
  }
  bool FactorizeNumerically(const SparseMatrix& lower) override { return inner_->Factorize(lower); }

 private:
  std::vector<int>& advice_;
  std::unique_ptr<SparseCholesky> inner_;
  std::vector<int> order_;
};

TEST(EliminatingCholesky, ALittleChangedPatternIsOrderedLikeTheOneBefore) {
  const Surface surface = GeneratedSurface("flat_delaunay_patch", 300);
  SparseMatrix lower = AngleFitMatrix(surface, 1e-3);
  std::vector<int> advice = {-1};
  const auto cholesky = MakeEliminatingCholesky(std::make_unique<AdvisedCholesky>(&advice));
  EXPECT_LT(SolveError(lower, cholesky.get()), 1e-9);
  EXPECT_TRUE(advice.empty());
  // Two triangles of three inner vertices each, across an edge that has become active.
  const Triangulation& t = surface.triangulation;
  const std::vector<bool> boundary = BoundaryVertices(t);
  const Index h = *std::find_if(t.edge_halfedge.begin(), t.edge_halfedge.end(), [&](Index e) {
    return t.twin[e] != kNone && !boundary[t.vertex[e]] && !boundary[t.vertex[t.twin[e]]] &&
           !boundary[t.Tail(e)] && !boundary[t.Tip(e)];
  });
  lower.coeffRef(Triangulation::Face(t.twin[h]), Triangulation::Face(h)) = -0.1;
  lower.makeCompressed();
  EXPECT_LT(SolveError(lower, cholesky.get()), 1e-9);
  const int kept = static_cast<int>(lower.cols()) - t.num_faces() + 2;
  ASSERT_EQ(static_cast<int>(advice.size()), kept);
  EXPECT_EQ(std::vector<int>(advice.begin(), advice.begin() + 2), (std::vector<int>{0, 1}));
  for (int k = 2; k < kept; ++k) EXPECT_EQ(advice[k], kept + 1 - k);
}

TEST(EliminatingCholesky, AnythingLeftOrNothing) {
  // Random sparse matrices, from diagonal ones (all is eliminated) to dense ones (nothing is).
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1, 1);
  for (const double density : {0.0, 0.05, 0.2, 1.0}) {
    Eigen::MatrixXd dense = 40 * Eigen::MatrixXd::Identity(40, 40);
    for (int i = 0; i < 40; ++i) {
      for (int j = 0; j < i; ++j) {
        if (std::abs(value(random)) <= density) dense(i, j) = dense(j, i) = value(random);
      }
    }
    const SparseMatrix lower = dense.triangularView<Eigen::Lower>().toDenseMatrix().sparseView();
    int size = 0;
    const auto cholesky = MakeEliminatingCholesky(std::make_unique<DenseCholesky>(&size));
    EXPECT_LT(SolveError(lower, cholesky.get()), 1e-13);
    EXPECT_EQ(size > 0, density > 0);
  }
}

TEST(EliminatingCholesky, IndefiniteMatricesAreRefusedOnEitherSide) {
  const Surface surface = GeneratedSurface("flat_delaunay_patch", 100);
  for (const double shift : {-4., -2.9}) {
    int size = -1;
    const auto cholesky = MakeEliminatingCholesky(std::make_unique<DenseCholesky>(&size));
    EXPECT_FALSE(cholesky->Factorize(AngleFitMatrix(surface, shift)));
  }
}

}  // namespace
}  // namespace cirque
