#include "cirque/solver/conjugate_gradients.h"

#include <cmath>

namespace cirque {
namespace {

constexpr int kTrialIterations = 6;

/// Whether the residual, should it go on falling as it has so far, reaches its target in time. The
/// first iterations say too little.
bool MayFinish(double start, double now, double target, int iterations, int max_iterations) {
  if (iterations >= max_iterations) return false;
  if (iterations < kTrialIterations) return true;
  const double done = std::log(start / now), wanted = std::log(start / target);
  return done * max_iterations >= wanted * iterations;
}

}  // namespace

CgResult ConjugateGradients(
    const SparseMatrix& lower, const Eigen::VectorXd& right_side,
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& precondition, double tolerance,
    int max_iterations, Eigen::VectorXd* x) {
  CgResult result;
  x->setZero(right_side.size());
  Eigen::VectorXd residual = right_side;
  Eigen::VectorXd direction, last_residual;
  double last_rho = 0;
  const double target = tolerance * right_side.norm();
  const double start = residual.norm();
  while (!(result.converged = residual.norm() <= target) &&
         MayFinish(start, residual.norm(), target, result.iterations, max_iterations)) {
    const Eigen::VectorXd z = precondition(residual);
    const double rho = residual.dot(z);
    if (result.iterations == 0) {
      direction = z;
    } else {
      direction = z + ((rho - last_residual.dot(z)) / last_rho) * direction;
    }
    last_rho = rho;
    last_residual = residual;
    const Eigen::VectorXd image = lower.selfadjointView<Eigen::Lower>() * direction;
    const double curvature = direction.dot(image);
    if (!(curvature > 0)) {
      result.positive = false;
      return result;
    }
    const double step = rho / curvature;
    *x += step * direction;
    residual -= step * image;
    ++result.iterations;
  }
  return result;
}

}  // namespace cirque
