#include "cirque/linear/registry.h"

#include <Eigen/SparseCholesky>
#include <glog/logging.h>

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

const Registry<SparseCholeskyFactory>& LinearSolvers() {
  static const Registry<SparseCholeskyFactory> kTable("linear solver",
                                                      {
#ifdef CIRQUE_CHOLMOD
                                                          {"cholmod", MakeCholmodCholesky},
#endif
                                                          {"eigen", MakeEigenCholesky},
                                                      });
  return kTable;
}

std::unique_ptr<SparseCholesky> MakeCholesky(const std::string& name) {
  const auto factory = LinearSolvers().Find(name.empty() ? LinearSolvers().Names().front() : name);
  CHECK(factory.ok()) << factory.status().message();
  return MakeEliminatingCholesky((*factory)());
}

}  // namespace cirque
