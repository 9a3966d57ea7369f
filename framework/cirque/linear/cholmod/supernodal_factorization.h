#pragma once

#ifdef CIRQUE_CHOLMOD

#include <complex>
#include <memory>
#include <vector>

#include <Eigen/SparseCore>
#include <cholmod.h>

#include "cirque/linear/cholmod/dense_trapezoid.h"
#include "cirque/linear/cholmod/supernodal_solver.h"

namespace cirque {

/// Computes the numbers of a supernodal LL' factor that CHOLMOD has analysed, as CHOLMOD does from
/// one column to the next (left-looking; Y. Chen, T. Davis, W. Hager, S. Rajamanickam, "Algorithm
/// 887", ACM Trans. Math. Softw. 35, 2008), but on all cores: the subtrees of the elimination tree
/// at once, then the supernodes of the top one after another, each by blocks of rows. The result
/// does not depend on the number of threads.
///
/// Of real symmetric and complex Hermitian matrices: Scalar is double or std::complex<double>.
template <class Scalar>
class SupernodalFactorization {
 public:
  using Matrix = Eigen::SparseMatrix<Scalar>;

  /// For matrices with the pattern of `lower`, of which `factor` is the analysis. The factor must
  /// outlive this.
  SupernodalFactorization(const Matrix& lower, const cholmod_factor& factor);

  /// Fills the factor's numbers, for which there is memory. False, and the numbers undefined, when
  /// a pivot is not positive.
  bool Compute(const Matrix& lower);

  /// Those of a supernode.
  DenseTrapezoid<Scalar> Numbers(int s) const;

  const SupernodalTree& tree() const { return tree_; }

 private:
  /// Rows begin to end - 1 of supernode d are columns of the one that is at work.
  struct Descendant {
    int d, begin, end;
  };
  struct Workspace;

  void ListByRows(const Matrix& lower);
  void TakeDescendants(int s, std::vector<Descendant>* descendants) const;
  void Fill(const Matrix& lower, int s, int* place) const;

  /// Takes a descendant's product out of the rows of s that are its rows `first` to `last` - 1.
  void Subtract(const Descendant& of, int s, int first, int last, const int* place,
                std::vector<Scalar>* product) const;
  void SubtractInBlocks(int s, const Workspace& work) const;

  /// Has d wait for the supernode of its next row; in `to_top`, if given, when that is there.
  void Pass(int d, int position, std::vector<int>* to_top);

  bool FactorInSubtree(const Matrix& lower, int s, Workspace* work, std::vector<int>* to_top);
  bool FactorAtTop(const Matrix& lower, int s, Workspace* work);

  const cholmod_factor& factor_;
  const SupernodalTree tree_;
  std::vector<int> place_in_order_;               ///< per unknown
  std::vector<int> row_start_, column_, entry_;   ///< the entries of `lower`, row by row
  std::vector<int> last_waiting_, waits_before_;  ///< per supernode, a list of descendants
  std::vector<int> position_;  ///< per supernode, how many of its rows are done with
};

/// The numbers of a real factor, as solves want them.
class RealSupernodes final : public SupernodeBlockNumbers {
 public:
  /// The factorization must outlive this.
  explicit RealSupernodes(const SupernodalFactorization<double>& of) : of_(of) {}

  void Solve(int s, double* w) const override;
  void SolveTransposed(int s, double* w) const override;
  void SolveTogether(int s, double* w) const override;
  void SolveTogetherTransposed(int s, double* w) const override;

 private:
  const SupernodalFactorization<double>& of_;
};

/// Those of a complex one; w has real and imaginary parts in turn.
class ComplexSupernodes final : public SupernodeNumbers {
 public:
  /// The factorization must outlive this.
  explicit ComplexSupernodes(const SupernodalFactorization<std::complex<double>>& of) : of_(of) {}

  void Solve(int s, double* w) const override;
  void SolveTransposed(int s, double* w) const override;

 private:
  const SupernodalFactorization<std::complex<double>>& of_;
};

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
