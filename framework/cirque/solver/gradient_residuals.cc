#include "cirque/solver/gradient_residuals.h"

#include <utility>
#include <vector>

#include <ceres/cost_function.h>

namespace cirque {

/// One entry of the gradient, in the parameters that it depends on.
class GradientResiduals::Row final : public ceres::CostFunction {
 public:
  Row(const GradientResiduals& shared, int row, std::vector<int> columns)
      : shared_(shared), row_(row), columns_(std::move(columns)) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->assign(columns_.size(), 1);
  }

  bool Evaluate(double const* const* /*x*/, double* residual, double** jacobians) const override {
    if (!shared_.is_defined_) return false;
    *residual = shared_.gradient_[row_];
    if (!jacobians) return true;
    SparseMatrix::InnerIterator entry(shared_.hessian_, row_);
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      while (entry.row() < columns_[k]) ++entry;
      if (jacobians[k]) *jacobians[k] = entry.value();
    }
    return true;
  }

 private:
  const GradientResiduals& shared_;
  int row_;
  std::vector<int> columns_;  ///< a subset of the shared Hessian's in that row, ascending
};

bool GradientResiduals::Update(const Eigen::VectorXd& x, bool with_jacobian) {
  is_defined_ = run_->Gradient(x, &gradient_);
  if (!is_defined_ || !with_jacobian) return true;
  is_defined_ = run_->Hessian(x, &lower_);
  if (!is_defined_) return true;
  if (pattern_.cols() == 0) pattern_.resize(lower_.rows(), lower_.cols());
  const auto known = pattern_.nonZeros();
  hessian_ = lower_.selfadjointView<Eigen::Lower>();
  hessian_ = SparseMatrix(pattern_ + hessian_);
  pattern_ = 0 * hessian_;
  return pattern_.nonZeros() == known;
}

void GradientResiduals::AddTo(double* x, ceres::Problem* problem) {
  const auto n = static_cast<int>(hessian_.cols());
  for (int i = 0; i < n; ++i) problem->AddParameterBlock(x + i, 1);
  for (int i = 0; i < n; ++i) {
    std::vector<int> columns;
    std::vector<double*> blocks;
    for (SparseMatrix::InnerIterator entry(hessian_, i); entry; ++entry) {
      columns.push_back(static_cast<int>(entry.row()));
      blocks.push_back(x + entry.row());
    }
    if (columns.empty()) continue;
    problem->AddResidualBlock(new Row(*this, i, std::move(columns)), nullptr, blocks);
  }
  for (const int gauge : energy_.GaugeParameters()) problem->SetParameterBlockConstant(x + gauge);
}

}  // namespace cirque
