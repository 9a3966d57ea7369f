#include "cirque/linear/eigen_cholesky.h"

#include <Eigen/SparseCholesky>

namespace cirque {
namespace {

class EigenCholesky final : public SparseCholesky {
 public:
  void Solve(const Eigen::VectorXd& b, Eigen::VectorXd* x) override { *x = factor_.solve(b); }

 protected:
  bool Analyze(const SparseMatrix& lower) override {
    factor_.analyzePattern(lower);
    return true;
  }

  bool FactorizeNumerically(const SparseMatrix& lower) override {
    factor_.factorize(lower);
    return factor_.info() == Eigen::Success;
  }

 private:
  Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower> factor_;
};

}  // namespace

std::unique_ptr<SparseCholesky> MakeEigenCholesky() { return std::make_unique<EigenCholesky>(); }

}  // namespace cirque
