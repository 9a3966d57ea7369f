#pragma once

#ifdef CIRQUE_CHOLMOD

#include <complex>
#include <optional>

#include <Eigen/Core>
#include <cholmod.h>

#include "cirque/linear/cholmod/large_buffer.h"
#include "cirque/linear/cholmod/supernodal_factorization.h"

namespace cirque {

/// Factors Hermitian positive definite matrices of one pattern by dense blocks, on all cores, as CHOLMOD
/// has analysed them, and solves.
class SupernodalHermitian {
 public:
  using Factorization = SupernodalFactorization<std::complex<double>>;

  SupernodalHermitian();
  ~SupernodalHermitian();
  SupernodalHermitian(const SupernodalHermitian&) = delete;
  SupernodalHermitian& operator=(const SupernodalHermitian&) = delete;

  /// False when the matrix is not positive definite in floating point, or memory ran out.
  bool Factorize(const Factorization::Matrix& lower);

  /// @pre Factorize returned true.
  Eigen::VectorXcd Solve(const Eigen::VectorXcd& b);

 private:
  bool Analyze(const Factorization::Matrix& lower);
  void FreeFactor();

  cholmod_common common_ = {};
  cholmod_factor* factor_ = nullptr;
  LargeBuffer numbers_;
  std::optional<Factorization> factorization_;
  std::optional<SupernodalSolver> solver_;
};

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
