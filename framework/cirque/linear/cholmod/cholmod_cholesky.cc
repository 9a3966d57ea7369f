#ifdef CIRQUE_CHOLMOD

#include <cmath>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include <cholmod.h>

#include "cirque/linear/cholmod/large_buffer.h"
#include "cirque/linear/cholmod/matrix_view.h"
#include "cirque/linear/cholmod/single_precision_factor.h"
#include "cirque/linear/cholmod/supernodal_factorization.h"
#include "cirque/linear/registry.h"

namespace cirque {
namespace {

constexpr int kManyUnknowns = 50'000;

/// From here on an ordering by nested dissection (METIS) is worth its time, nine times that of AMD, for
/// the memory: its factors have 0.85 of the numbers at 106,000 unknowns, 0.74 at 430,000, and so on. 16
/// million triangles are mapped in 19.8 GiB, with AMD not in 21; 8.7 million took half as long again.
constexpr Eigen::Index kToBeDissected = 8'000'000;

/// Operations an entry of the factor from which on it is supernodal, as CHOLMOD's are from 40 on: at 38.9
/// supernodes take a quarter off an interior point fit, below 20 narrow ones cost more than they save.
constexpr double kSupernodal = 30;

/// Of a factor, for n unknowns on a surface, as multiples of n log2(n): 2.4 to 5 were measured from
/// kManyUnknowns on.
constexpr double kLeastNumbers = 2.4;

cholmod_dense View(const Eigen::VectorXd& vector) {
  cholmod_dense view = {};
  view.nrow = view.nzmax = view.d = static_cast<size_t>(vector.size());
  view.ncol = 1;
  view.x = const_cast<double*>(vector.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

class CholmodCholesky final : public SparseCholesky {
 public:
  CholmodCholesky() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.nmethods = 1;
    common_.supernodal_switch = kSupernodal;
    common_.postorder = 1;
    common_.final_ll = 1;
    common_.quick_return_if_not_posdef = 1;
  }

  ~CholmodCholesky() override {
    FreeFactor();
    cholmod_free_dense(&solution_, &common_);
    cholmod_free_dense(&workspace_, &common_);
    cholmod_free_dense(&second_workspace_, &common_);
    cholmod_finish(&common_);
  }

  CholmodCholesky(const CholmodCholesky&) = delete;
  CholmodCholesky& operator=(const CholmodCholesky&) = delete;

  void Solve(const Eigen::VectorXd& b, Eigen::VectorXd* x) override {
    if (solver_) {
      if (rounded_) return solver_->Solve(*rounded_, b, x);
      return solver_->Solve(RealSupernodes(*supernodal_), b, x);
    }
    cholmod_dense right_side = View(b);
    cholmod_solve2(CHOLMOD_A, factor_, &right_side, nullptr, &solution_, nullptr, &workspace_,
                   &second_workspace_, &common_);
    ThrowIfOutOfMemory();
    *x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution_->x), b.size());
  }

  void SolveTogether(const Eigen::MatrixXd& b, Eigen::MatrixXd* x) override {
    if (!solver_ || rounded_ || b.cols() == 1) return SparseCholesky::SolveTogether(b, x);
    solver_->SolveTogether(RealSupernodes(*supernodal_), b, x);
  }

  void Reserve(int unknowns) override {
    if (unknowns < kManyUnknowns) return;
    numbers_.ReserveAhead(static_cast<std::size_t>(kLeastNumbers * unknowns * std::log2(unknowns)));
  }

  void KeepInSinglePrecision() override {
    if (!supernodal_ || rounded_) return;
    rounded_ = SinglePrecisionFactor::Round(*factor_, supernodal_->tree());
    if (rounded_) numbers_.Release(rounded_->NumBytes() / sizeof(double) + 1);
  }

  std::vector<int> Ordering() const override {
    if (!factor_) return {};
    const int* order = static_cast<const int*>(factor_->Perm);
    return {order, order + factor_->n};
  }

  void SuggestOrdering(std::vector<int> order) override { suggested_ = std::move(order); }

 protected:
  bool Analyze(const SparseMatrix& lower) override {
    FreeFactor();
    cholmod_sparse a = ViewOf(lower);
    const bool given = static_cast<Eigen::Index>(suggested_.size()) == lower.cols();
    const int own = lower.cols() < kToBeDissected ? CHOLMOD_AMD : CHOLMOD_METIS;
    common_.method[0].ordering = given ? CHOLMOD_GIVEN : own;
    factor_ = cholmod_analyze_p(&a, given ? suggested_.data() : nullptr, nullptr, 0, &common_);
    suggested_ = {};
    ThrowIfOutOfMemory();
    if (!factor_ || !LendMemory()) return false;
    if (factor_->is_super) {
      supernodal_.emplace(lower, *factor_);
      solver_.emplace(supernodal_->tree(), static_cast<const int*>(factor_->Perm));
    }
    return true;
  }

  bool FactorizeNumerically(const SparseMatrix& lower) override {
    rounded_.reset();
    if (supernodal_) {
      numbers_.Touch(factor_->xsize);
      return supernodal_->Compute(lower);
    }
    cholmod_sparse a = ViewOf(lower);
    const bool done = cholmod_factorize(&a, factor_, &common_) != 0;
    ThrowIfOutOfMemory();
    return done && common_.status == CHOLMOD_OK && factor_->minor == factor_->n;
  }

 private:
  /// Which is not that the matrix is not positive definite, and not to be mended by another.
  void ThrowIfOutOfMemory() const {
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  }

  /// Gives a supernodal factor our memory for its numbers, as its numeric factorization would find
  /// it from the second time on. CHOLMOD itself returns that memory to the system with every new
  /// analysis, and to be given pages anew takes up to half the time of factoring.
  bool LendMemory() {
    if (!factor_->is_super) numbers_.Release(0);
    if (!factor_->is_super || factor_->xtype != CHOLMOD_PATTERN) return true;
    if (!numbers_.Reserve(factor_->xsize)) return false;
    factor_->x = numbers_.data();
    factor_->xtype = CHOLMOD_REAL;
    factor_->dtype = CHOLMOD_DOUBLE;
    factor_->is_ll = 1;
    return true;
  }

  void FreeFactor() {
    rounded_.reset();
    solver_.reset();
    supernodal_.reset();
    if (factor_ && factor_->x == numbers_.data()) factor_->x = nullptr;
    cholmod_free_factor(&factor_, &common_);
  }

  /// Of supernodal factors.
  std::optional<SupernodalFactorization<double>> supernodal_;
  std::optional<SupernodalSolver> solver_;
  std::unique_ptr<SinglePrecisionFactor> rounded_;
  LargeBuffer numbers_;
  std::vector<int> suggested_;  ///< order of the next analysis; empty: AMD's
  cholmod_common common_ = {};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense* solution_ = nullptr;
  cholmod_dense* workspace_ = nullptr;
  cholmod_dense* second_workspace_ = nullptr;
};

}  // namespace

std::unique_ptr<SparseCholesky> MakeCholmodCholesky() {
  return std::make_unique<CholmodCholesky>();
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
