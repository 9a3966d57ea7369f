#include "cirque/solver/eigen_cholesky.h"

#include <Eigen/SparseCholesky>

namespace cirque {
namespace {

class EigenCholesky final : public SparseCholesky {
 public:
  Eigen::VectorXd Solve(const Eigen::VectorXd& right_side) override {
    return factor_.solve(right_side);
  }

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
