#include "cirque/linear/conjugate_gradients.h"

#include <cmath>

#include "cirque/core/parallel.h"

namespace cirque {
namespace {

constexpr int kTrialIterations = 6;

/// Whether the residual, should it go on falling as it has so far, reaches its target in time. The
/// first iterations say too little.
bool MayFinish(double start, double now, double target, int iterations, int max_iterations) {
  if (iterations >= max_iterations) return false;
  if (iterations < kTrialIterations) return true;
  const double done = std::log(start / now), needed = std::log(start / target);
  return done * max_iterations >= needed * iterations;
}

/// y = x_factor x + y_factor y; with y_factor 0 y is not read, and takes the size of x.
void Combine(double x_factor, const Eigen::VectorXd& x, double y_factor, Eigen::VectorXd* y) {
  if (y_factor == 0) y->resize(x.size());
  ForEachBlock(static_cast<int>(x.size()), [&](int, int begin, int end) {
    auto part = y->segment(begin, end - begin);
    if (y_factor == 0) {
      part = x_factor * x.segment(begin, end - begin);
    } else {
      part = x_factor * x.segment(begin, end - begin) + y_factor * part;
    }
  });
}

}  // namespace

double Dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const int n = static_cast<int>(a.size());
  Eigen::VectorXd of_block(NumBlocks(n));
  ForEachBlock(n, [&](int block, int begin, int end) {
    of_block[block] = a.segment(begin, end - begin).dot(b.segment(begin, end - begin));
  });
  return of_block.sum();
}

CgResult ConjugateGradients(const LinearOperator& apply, const Eigen::VectorXd& right_side,
                            const Preconditioner& precondition, double tolerance,
                            int max_iterations, Eigen::VectorXd* x, const InnerProduct& dot) {
  const auto norm = [&](const Eigen::VectorXd& a) { return std::sqrt(dot(a, a)); };
  CgResult result;
  Eigen::VectorXd residual, direction, image, z;
  Combine(1, right_side, 0, &residual);
  const double start = norm(residual), target = tolerance * start;
  double now = start, last_rho = 1, last_step = 0;
  while (!(result.converged = now <= target) &&
         MayFinish(start, now, target, result.iterations, max_iterations)) {
    precondition(residual, &z);
    const double rho = dot(residual, z);
    // Residuals differ by the step's share of the image.
    const bool first = result.iterations == 0;
    Combine(1, z, first ? 0 : -last_step * dot(image, z) / last_rho, &direction);
    apply(direction, &image);
    const double curvature = dot(direction, image);
    if (!(curvature > 0)) {
      result.positive = false;
      break;
    }
    last_rho = rho;
    last_step = rho / curvature;
    Combine(last_step, direction, first ? 0 : 1, x);
    Combine(-last_step, image, 1, &residual);
    now = norm(residual);
    ++result.iterations;
  }
  if (result.iterations == 0) x->setZero(right_side.size());
  return result;
}

CgResult ConjugateGradients(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                            const Preconditioner& precondition, double tolerance,
                            int max_iterations, Eigen::VectorXd* x) {
  const auto apply = [&lower](const Eigen::VectorXd& from, Eigen::VectorXd* to) {
    to->noalias() = lower.selfadjointView<Eigen::Lower>() * from;
  };
  return ConjugateGradients(apply, right_side, precondition, tolerance, max_iterations, x);
}

}  // namespace cirque
