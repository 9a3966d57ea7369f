#include "cirque/linear/hermitian_cholesky.h"

#include <Eigen/SparseCholesky>

#include "cirque/linear/cholmod/supernodal_hermitian.h"

namespace cirque {

class HermitianCholesky::Factor {
 public:
  virtual ~Factor() = default;
  virtual bool Factorize(const ComplexSparseMatrix& lower) = 0;
  virtual Eigen::VectorXcd Solve(const Eigen::VectorXcd& b) = 0;
};

class HermitianCholesky::ByColumns final : public Factor {
 public:
  explicit ByColumns(const ComplexSparseMatrix& lower) { solver_.analyzePattern(lower); }

  bool Factorize(const ComplexSparseMatrix& lower) override {
    solver_.factorize(lower);
    return solver_.info() == Eigen::Success;
  }

  Eigen::VectorXcd Solve(const Eigen::VectorXcd& b) override { return solver_.solve(b); }

 private:
  Eigen::SimplicialLLT<ComplexSparseMatrix, Eigen::Lower> solver_;
};

#ifdef CIRQUE_CHOLMOD
namespace {

constexpr Eigen::Index kSupernodal = 1000;  ///< unknowns from which dense blocks pay

}  // namespace

class HermitianCholesky::ByBlocks final : public Factor {
 public:
  bool Factorize(const ComplexSparseMatrix& lower) override { return solver_.Factorize(lower); }
  Eigen::VectorXcd Solve(const Eigen::VectorXcd& b) override { return solver_.Solve(b); }

 private:
  SupernodalHermitian solver_;
};
#endif

HermitianCholesky::HermitianCholesky() = default;
HermitianCholesky::~HermitianCholesky() = default;

bool HermitianCholesky::Factorize(const ComplexSparseMatrix& lower) {
  if (!factor_) factor_ = Make(lower);
  return factor_->Factorize(lower);
}

std::unique_ptr<HermitianCholesky::Factor> HermitianCholesky::Make(
    const ComplexSparseMatrix& lower) {
#ifdef CIRQUE_CHOLMOD
  if (lower.rows() >= kSupernodal) return std::make_unique<ByBlocks>();
#endif
  return std::make_unique<ByColumns>(lower);
}

Eigen::VectorXcd HermitianCholesky::Solve(const Eigen::VectorXcd& right_side) const {
  return factor_->Solve(right_side);
}

}  // namespace cirque
