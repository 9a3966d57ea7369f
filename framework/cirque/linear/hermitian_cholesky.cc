#include "cirque/linear/hermitian_cholesky.h"

#ifdef CIRQUE_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

namespace cirque {
namespace {

#ifdef CIRQUE_CHOLMOD
class Solver final : public Eigen::CholmodSupernodalLLT<ComplexSparseMatrix, Eigen::Lower> {
 public:
  Solver() {
    cholmod().print = 0;
    cholmod().nmethods = 1;
    cholmod().method[0].ordering = CHOLMOD_AMD;
    cholmod().quick_return_if_not_posdef = 1;
  }
};
#else
using Solver = Eigen::SimplicialLLT<ComplexSparseMatrix, Eigen::Lower>;
#endif

}  // namespace

class HermitianCholesky::Factor {
 public:
  bool Factorize(const ComplexSparseMatrix& lower) {
    if (!analyzed_) solver_.analyzePattern(lower);
    analyzed_ = true;
    solver_.factorize(lower);
    return solver_.info() == Eigen::Success;
  }

  Eigen::VectorXcd Solve(const Eigen::VectorXcd& b) const { return solver_.solve(b); }

 private:
  Solver solver_;
  bool analyzed_ = false;
};

HermitianCholesky::HermitianCholesky() : factor_(std::make_unique<Factor>()) {}
HermitianCholesky::~HermitianCholesky() = default;

bool HermitianCholesky::Factorize(const ComplexSparseMatrix& lower) {
  return factor_->Factorize(lower);
}

Eigen::VectorXcd HermitianCholesky::Solve(const Eigen::VectorXcd& right_side) const {
  return factor_->Solve(right_side);
}

}  // namespace cirque
