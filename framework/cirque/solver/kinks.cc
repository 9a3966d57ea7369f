#include "cirque/solver/kinks.h"

namespace cirque {

void Kinks::TakeLeastSubgradient(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) const {
  for (const Kink& kink : kinks_) {
    if (x[kink.parameter] != 0) continue;
    double& slope = (*gradient)[kink.parameter];
    const double above = slope + kink.jump;
    if (slope <= 0) slope = above < 0 ? above : 0;
  }
}

void Kinks::Hold(const Eigen::VectorXd& x, const Eigen::VectorXd& subgradient,
                 SparseMatrix* lower) const {
  std::vector<bool> held(x.size(), false);
  for (const auto& [k, jump] : kinks_) held[k] = x[k] == 0 && subgradient[k] == 0;
  for (int j = 0; j < lower->outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(*lower, j); entry; ++entry) {
      if (entry.row() != j && (held[j] || held[entry.row()])) entry.valueRef() = 0;
    }
  }
}

void Kinks::StopAt(const Eigen::VectorXd& x, const Eigen::VectorXd& subgradient,
                   Eigen::VectorXd* trial) const {
  for (const auto& [k, jump] : kinks_) {
    const double side = x[k] != 0 ? x[k] : -subgradient[k];
    if ((*trial)[k] * side <= 0) (*trial)[k] = 0;
  }
}

}  // namespace cirque
