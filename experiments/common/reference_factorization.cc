#include "experiments/common/reference_factorization.h"

#include <cmath>
#include <ctime>

#ifdef CIRQUE_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include "cirque/linear/registry.h"
#endif
#include <glog/logging.h>

#include "cirque/core/solve_summary.h"
#include "cirque/energy/dual_laplacian.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {
namespace {

constexpr double kShift = 1e-8;  ///< makes the Laplacian definite

double ThreadSeconds() {
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

SparseMatrix CotangentLaplacian(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const CornerAngles angles = MeasureSurface(t, lengths).angles;
  LaplacianAssembler laplacian(t.num_vertices, static_cast<std::size_t>(t.num_halfedges()));
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    laplacian.Add(t.Tail(h), t.Tip(h), 0.5 / std::tan(angles.value[h]));
  }
  SparseMatrix lower;
  laplacian.Assemble(&lower);
  for (int v = 0; v < lower.cols(); ++v) lower.coeffRef(v, v) += kShift;
  return lower;
}

#ifdef CIRQUE_CHOLMOD

/// CHOLMOD on one core with the ordering that is cheapest here, and nothing of ours.
bool Factorize(const SparseMatrix& lower) {
  Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower> cholesky;
  cholesky.cholmod().nmethods = 1;
  cholesky.cholmod().method[0].ordering = CHOLMOD_AMD;
  cholesky.compute(lower);
  return cholesky.info() == Eigen::Success;
}

#else

bool Factorize(const SparseMatrix& lower) { return MakeEigenCholesky()->Factorize(lower); }

#endif

ReferenceFactorization TimeFactorization(const SparseMatrix& lower) {
  const Timer timer;
  const double cpu_before = ThreadSeconds();
  CHECK(Factorize(lower)) << "the Laplacian is not positive definite";
  return {timer.Seconds(), ThreadSeconds() - cpu_before};
}

}  // namespace

ReferenceFactorization TimeReferenceFactorization(const Surface& surface, int repeats) {
  const SparseMatrix laplacian = CotangentLaplacian(surface);
  ReferenceFactorization best = TimeFactorization(laplacian);
  for (int i = 1; i < repeats; ++i) {
    const ReferenceFactorization again = TimeFactorization(laplacian);
    if (again.cpu_seconds < best.cpu_seconds) best = again;
  }
  return best;
}

ReferenceFactorization TimeDualFactorization(const Triangulation& triangulation) {
  SparseMatrix lower;
  DualLaplacian(triangulation)
      .Assemble(Eigen::VectorXd::Ones(triangulation.num_halfedges()), &lower);
  for (Index f = 0; f < triangulation.num_faces(); ++f) lower.coeffRef(f, f) += kShift;
  return TimeFactorization(lower);
}

}  // namespace cirque
