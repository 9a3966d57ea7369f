#pragma once

#include <complex>
#include <memory>

#include <Eigen/SparseCore>

namespace cirque {

using ComplexSparseMatrix = Eigen::SparseMatrix<std::complex<double>>;

/// Factors Hermitian positive definite complex matrices of one pattern, given by their lower
/// triangle, and solves with the factor: small ones column by column (Eigen), large ones by dense
/// blocks (CHOLMOD, when built with it). The first factorization analyses the pattern for all.
class HermitianCholesky {
 public:
  HermitianCholesky();
  ~HermitianCholesky();

  /// False when the matrix is not positive definite in floating point (or memory ran out).
  /// @pre the pattern is that of the call before.
  bool Factorize(const ComplexSparseMatrix& lower);

  /// x = A^-1 b with the last factor. @pre Factorize returned true.
  Eigen::VectorXcd Solve(const Eigen::VectorXcd& right_side) const;

 private:
  class Factor;
  class ByColumns;
  class ByBlocks;
  static std::unique_ptr<Factor> Make(const ComplexSparseMatrix& lower);

  std::unique_ptr<Factor> factor_;
};

}  // namespace cirque
