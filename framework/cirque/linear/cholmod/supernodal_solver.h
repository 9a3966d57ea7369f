#pragma once

#ifdef CIRQUE_CHOLMOD

#include <vector>

#include <Eigen/Core>

#include "cirque/linear/cholmod/supernodal_tree.h"

namespace cirque {

/// What triangular solves want of the numbers of a factor, supernode by supernode, each with the
/// entries w of its rows; its columns come first.
class SupernodeNumbers {
 public:
  /// Solves may touch that many zeros behind the last row.
  static constexpr int kPadding = 3;

  virtual ~SupernodeNumbers() = default;

  /// w of the columns becomes L^-1 w, and is taken out of that of the rows below.
  virtual void Solve(int s, double* w) const = 0;

  /// w of the columns becomes L^-* w, given that of the rows below.
  virtual void SolveTransposed(int s, double* w) const = 0;
};

/// What solves of several right sides at once want besides.
class SupernodeBlockNumbers : public SupernodeNumbers {
 public:
  static constexpr int kTogether = 8;

  /// The same as Solve and SolveTransposed for so many right sides: w has their entries row by row,
  /// those of a row side by side.
  virtual void SolveTogether(int s, double* w) const = 0;
  virtual void SolveTogetherTransposed(int s, double* w) const = 0;
};

/// Solves with a supernodal factor on all cores: subtrees of the elimination tree at once, the
/// top after them going forward and before them going back. The result does not depend on the
/// number of threads.
class SupernodalSolver {
 public:
  /// `order` is the factor's, of the unknowns. Both must outlive this.
  SupernodalSolver(const SupernodalTree& tree, const int* order);

  /// x = (L L*)^-1 b, the unknowns in their order before that of the factor.
  void Solve(const SupernodeNumbers& numbers, const Eigen::VectorXd& b, Eigen::VectorXd* x);

  /// The same with the numbers of a complex factor: w has real and imaginary parts in turn.
  void Solve(const SupernodeNumbers& numbers, const Eigen::VectorXcd& b, Eigen::VectorXcd* x);

  /// The same of every column of b, by so many at once as the numbers are for.
  void SolveTogether(const SupernodeBlockNumbers& numbers, const Eigen::MatrixXd& b,
                     Eigen::MatrixXd* x);

 private:
  /// Solves for the columns of s and takes them out of the rows below: out of x_, or of `far` by
  /// number where the row belongs to the top and s does not.
  /// Of kWidth right sides, whose entries of a row lie side by side everywhere; or of one, with the
  /// kComplex parts of its entries.
  template <int kWidth, class Numbers>
  void Forward(const Numbers& numbers, int s, double* far, Eigen::VectorXd* work);
  template <int kWidth, class Numbers>
  void Backward(const Numbers& numbers, int s, Eigen::VectorXd* work);

  template <int kWidth, class Numbers>
  void ForwardAll(const Numbers& numbers);
  template <int kWidth, class Numbers>
  void BackwardAll(const Numbers& numbers);

  void MakeRoom(int width);

  template <int kWidth, class Vector>
  void SolveOne(const SupernodeNumbers& numbers, const Vector& b, Vector* x);

  const SupernodalTree& tree_;
  const int* order_;
  Eigen::VectorXd x_;                        ///< in the factor's order
  std::vector<Eigen::VectorXd> far_, work_;  ///< per group: of the top's columns, of a supernode
};

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
