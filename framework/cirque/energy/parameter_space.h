#pragma once

#include <cmath>

#include <Eigen/Core>

namespace cirque {

/// What solvers ask of vectors of all parameters, of which several processes may each have a part.
/// This is that of one process, which has them whole. What it answers is the same on all, which ask
/// in the same order.
class ParameterSpace {
 public:
  virtual ~ParameterSpace() = default;

  virtual double Dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return a.dot(b); }
  virtual double LargestEntry(const Eigen::VectorXd& a) const {
    return a.lpNorm<Eigen::Infinity>();
  }
  double Norm(const Eigen::VectorXd& a) const { return std::sqrt(Dot(a, a)); }

  /// Whether it is so on every process.
  virtual bool All(bool mine) const { return mine; }

  /// What the first process says: of clocks, and of what its caller wants.
  virtual bool FirstSays(bool mine) const { return mine; }

  /// All entries of x, on the first process: x itself, or in `room`.
  virtual const Eigen::VectorXd& Whole(const Eigen::VectorXd& x, Eigen::VectorXd* /*room*/) const {
    return x;
  }
};

}  // namespace cirque
