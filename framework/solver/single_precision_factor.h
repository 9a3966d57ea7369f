#pragma once

#ifdef CIRQUE_CHOLMOD

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>
#include <cholmod.h>

#include "cirque/solver/supernodal_tree.h"

namespace cirque {

/// A supernodal LL' factor of CHOLMOD with its numbers rounded to single precision: a
/// preconditioner. A triangular solve does little but read the factor from main memory once, so it
/// takes a third of the time, and half of that on two cores: branches of the elimination tree are
/// solved at once, the trunk after them going forward and before them going back. The result does
/// not depend on the number of threads.
class SinglePrecisionFactor {
 public:
  /// Rounds the numbers of a factor where they are: CHOLMOD cannot solve with it any more, only
  /// factor anew, which ends this. The factor must outlive this. Null, and nothing done, when
  /// numbers are out of the range of single precision.
  static std::unique_ptr<SinglePrecisionFactor> Round(const cholmod_factor& factor);

  /// The memory that the numbers fill, from the first of the factor's on [bytes].
  std::size_t NumBytes() const { return start_.back() * sizeof(float); }

  /// x = (L~ L~')^-1 b with L~ the rounded factor, in its unknowns' order before CHOLMOD's.
  void Solve(const Eigen::VectorXd& b, Eigen::VectorXd* x);

 private:
  explicit SinglePrecisionFactor(const cholmod_factor& factor);
  const double* Doubles(int s) const;
  const float* Singles(int s) const { return static_cast<const float*>(factor_.x) + start_[s]; }
  bool CanRound() const;
  void RoundInPlace();

  /// Behind the last supernode from `begin` on whose single numbers will lie before where the
  /// double ones of `begin` are: those can be rounded in any order. At least one.
  int EndOfFree(int begin) const;

  /// Solves for the columns of s and takes them out of the rows below: out of x, or of `far` by
  /// number where the row belongs to the trunk and s does not.
  void Forward(int s, double* x, double* far, Eigen::VectorXd* work) const;
  void Backward(int s, double* x, Eigen::VectorXd* work) const;

  void ForwardAll();
  void BackwardAll();

  const cholmod_factor& factor_;
  const SupernodalTree tree_;
  std::vector<std::size_t> start_;           ///< per supernode, where its numbers begin
  Eigen::VectorXd x_;                        ///< in CHOLMOD's order
  std::vector<Eigen::VectorXd> far_, work_;  ///< per group: of the trunk's columns, of a supernode
};

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
