#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/supernodal_hermitian.h"

#include "cirque/linear/cholmod/matrix_view.h"

namespace cirque {

SupernodalHermitian::SupernodalHermitian() {
  cholmod_start(&common_);
  common_.print = 0;
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_AMD;
  common_.postorder = 1;
  common_.supernodal = CHOLMOD_SUPERNODAL;
}

SupernodalHermitian::~SupernodalHermitian() {
  FreeFactor();
  cholmod_finish(&common_);
}

void SupernodalHermitian::FreeFactor() {
  if (factor_) factor_->x = nullptr;  // the numbers are ours
  cholmod_free_factor(&factor_, &common_);
}

bool SupernodalHermitian::Factorize(const Factorization::Matrix& lower) {
  if (!factorization_ && !Analyze(lower)) return false;
  numbers_.Touch(2 * factor_->xsize);
  return factorization_->Compute(lower);
}

bool SupernodalHermitian::Analyze(const Factorization::Matrix& lower) {
  FreeFactor();  // of an analysis for whose numbers there was no memory
  cholmod_sparse a = ViewOf(lower);
  factor_ = cholmod_analyze(&a, &common_);
  if (!factor_ || !numbers_.Reserve(2 * factor_->xsize)) return false;
  factor_->x = numbers_.data();
  factorization_.emplace(lower, *factor_);
  solver_.emplace(factorization_->tree(), static_cast<const int*>(factor_->Perm));
  return true;
}

Eigen::VectorXcd SupernodalHermitian::Solve(const Eigen::VectorXcd& b) {
  Eigen::VectorXcd x;
  solver_->Solve(ComplexSupernodes(*factorization_), b, &x);
  return x;
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
