#include "experiments/common/reference_factorization.h"

#include <cmath>
#include <ctime>

#include <glog/logging.h>

#include "cirque/core/timer.h"
#include "cirque/energy/dual_laplacian.h"
#include "cirque/energy/laplacian_assembler.h"
#include "cirque/mesh/corner_angles.h"
#include "cirque/solver/sparse_cholesky.h"

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
  const CornerAngles angles = MeasureCornerAngles(t, MeasureEdgeLengths(surface));
  LaplacianAssembler laplacian(t.num_vertices, static_cast<std::size_t>(t.num_halfedges()));
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    laplacian.Add(t.Tail(h), t.Tip(h), 0.5 / std::tan(angles.value[h]));
  }
  SparseMatrix lower;
  laplacian.Assemble(&lower);
  for (int v = 0; v < lower.cols(); ++v) lower.coeffRef(v, v) += kShift;
  return lower;
}

ReferenceFactorization TimeFactorization(const SparseMatrix& lower, SparseCholesky* cholesky) {
  const Timer timer;
  const double cpu_before = ThreadSeconds();
  CHECK(cholesky->Factorize(lower)) << "the Laplacian is not positive definite";
  return {timer.Seconds(), ThreadSeconds() - cpu_before};
}

}  // namespace

ReferenceFactorization TimeReferenceFactorization(const Surface& surface) {
  const SparseMatrix lower = CotangentLaplacian(surface);
  const auto factory = LinearSolvers().Find(LinearSolvers().Names().front());
  CHECK(factory.ok());
  return TimeFactorization(lower, (*factory)().get());
}

ReferenceFactorization TimeDualFactorization(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  SparseMatrix lower;
  DualLaplacian(t).Assemble(Eigen::VectorXd::Ones(t.num_halfedges()), &lower);
  for (Index f = 0; f < t.num_faces(); ++f) lower.coeffRef(f, f) += kShift;
  return TimeFactorization(lower, MakeCholesky().get());
}

}  // namespace cirque
