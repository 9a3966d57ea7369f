// What one linear conformal map costs at least: analysis and factorization of the V x V cotangent
// Laplacian, beside which bench_solver is to be read.
#include <cmath>

#include <benchmark/benchmark.h>

#include "cirque/energy/dual_laplacian.h"
#include "cirque/linear/registry.h"

#include "bench/terrain.h"

namespace cirque {
namespace {

// Makes the Laplacian definite.
constexpr double kShift = 1e-8;

SparseMatrix CotangentLaplacian(const Triangulation& t, const Eigen::VectorXd& angles) {
  LaplacianAssembler laplacian(t.num_vertices, static_cast<std::size_t>(t.num_halfedges()));
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    laplacian.Add(t.Tail(h), t.Tip(h), 0.5 / std::tan(angles[h]));
  }
  SparseMatrix lower;
  laplacian.Assemble(&lower);
  for (int v = 0; v < lower.cols(); ++v) lower.coeffRef(v, v) += kShift;
  return lower;
}

void TimeCotangentFactorization(benchmark::State& state) {
  const EnergyInput& input = Terrain(static_cast<int>(state.range(0)));
  const SparseMatrix lower = CotangentLaplacian(input.triangulation, input.reference.value);
  for (auto _ : state) {
    const auto cholesky = MakeCholesky();
    if (!cholesky->Factorize(lower)) state.SkipWithError("not positive definite");
  }
}
BENCHMARK(TimeCotangentFactorization)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cirque
