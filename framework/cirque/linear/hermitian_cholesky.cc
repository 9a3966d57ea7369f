#include "cirque/linear/hermitian_cholesky.h"

#include <variant>

#include <Eigen/SparseCholesky>
#ifdef CIRQUE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace cirque {
namespace {

using Simplicial = Eigen::SimplicialLLT<ComplexSparseMatrix, Eigen::Lower>;

#ifdef CIRQUE_CHOLMOD
constexpr Eigen::Index kSupernodal = 2500;  ///< unknowns from which dense blocks pay

class Supernodal final : public Eigen::CholmodSupernodalLLT<ComplexSparseMatrix, Eigen::Lower> {
 public:
  Supernodal() {
    cholmod().print = 0;
    cholmod().nmethods = 1;
    cholmod().method[0].ordering = CHOLMOD_AMD;
    cholmod().quick_return_if_not_posdef = 1;
  }
};
#endif

}  // namespace

class HermitianCholesky::Factor {
  // A deduced type must be known before it is used.
  template <class Call>
  auto Visit(const Call& call) {
#ifdef CIRQUE_CHOLMOD
    if (auto* supernodal = std::get_if<Supernodal>(&solver_)) return call(supernodal);
#endif
    return call(std::get_if<Simplicial>(&solver_));
  }

 public:
  bool Factorize(const ComplexSparseMatrix& lower) {
    if (std::holds_alternative<std::monostate>(solver_)) Analyze(lower);
    return Visit([&](auto* solver) {
      solver->factorize(lower);
      return solver->info() == Eigen::Success;
    });
  }

  Eigen::VectorXcd Solve(const Eigen::VectorXcd& b) {
    return Visit([&](auto* solver) -> Eigen::VectorXcd { return solver->solve(b); });
  }

 private:
  void Analyze(const ComplexSparseMatrix& lower) {
#ifdef CIRQUE_CHOLMOD
    if (lower.rows() >= kSupernodal) {
      solver_.emplace<Supernodal>().analyzePattern(lower);
      return;
    }
#endif
    solver_.emplace<Simplicial>().analyzePattern(lower);
  }

#ifdef CIRQUE_CHOLMOD
  std::variant<std::monostate, Simplicial, Supernodal> solver_;
#else
  std::variant<std::monostate, Simplicial> solver_;
#endif
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
