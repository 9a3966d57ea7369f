// One factorization of a known pattern, and one solve, by every sparse Cholesky factorization of the
// registry and by the Hermitian one: Laplacians of square grids, complex ones with turned edges.
#include <cmath>
#include <complex>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include "cirque/linear/hermitian_cholesky.h"
#include "cirque/linear/registry.h"

#include "bench/registration.h"

namespace cirque {
namespace {

/// About as many unknowns, an edge's entry -turn; lower triangle.
template <class Scalar>
Eigen::SparseMatrix<Scalar> Grid(int unknowns, Scalar turn) {
  const int side = static_cast<int>(std::sqrt(unknowns));
  std::vector<Eigen::Triplet<Scalar>> entries;
  for (int i = 0; i < side * side; ++i) {
    entries.emplace_back(i, i, Scalar(6.1));
    const bool right = i % side + 1 < side, up = i + side < side * side;
    if (right) entries.emplace_back(i + 1, i, -turn);
    if (up) entries.emplace_back(i + side, i, -turn);
    if (right && up) entries.emplace_back(i + side + 1, i, -turn);
  }
  Eigen::SparseMatrix<Scalar> lower(side * side, side * side);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

template <class Matrix, class Cholesky>
void TimeFactor(benchmark::State& state, const Matrix& lower, Cholesky* cholesky) {
  for (auto _ : state) {
    if (!cholesky->Factorize(lower)) return state.SkipWithError("not factored");
  }
}

template <class Matrix, class Cholesky>
void TimeSolve(benchmark::State& state, const Matrix& lower, Cholesky* cholesky) {
  using Vector = Eigen::Matrix<typename Matrix::Scalar, Eigen::Dynamic, 1>;
  if (!cholesky->Factorize(lower)) return state.SkipWithError("not factored");
  const Vector b = Vector::LinSpaced(lower.cols(), -1, 2);
  for (auto _ : state) benchmark::DoNotOptimize(Vector(cholesky->Solve(b)).data());
}

template <class Scalar, class Make>
void Register(const std::string& name, Scalar turn, const Make& make) {
  RegisterBySize("factor/" + name, {kSmall, kLarge}, [=](benchmark::State& state, int unknowns) {
    TimeFactor(state, Grid(unknowns, turn), make().get());
  });
  RegisterBySize("solve/" + name, {kSmall, kLarge}, [=](benchmark::State& state, int unknowns) {
    TimeSolve(state, Grid(unknowns, turn), make().get());
  });
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const std::string& name : LinearSolvers().Names()) {
    Register(name, 1.0, [=] { return MakeCholesky(name); });
  }
  Register("hermitian", std::polar(1.0, 0.3), [] { return std::make_unique<HermitianCholesky>(); });
  return true;
}();

}  // namespace
}  // namespace cirque
