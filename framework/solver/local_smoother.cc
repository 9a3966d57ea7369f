#include "cirque/solver/local_smoother.h"

#include <algorithm>
#include <cmath>

#include "cirque/solver/lower_triangle.h"

namespace cirque {

namespace {

constexpr double kChanged = 0.05;      ///< of a diagonal entry
constexpr double kMostChanged = 0.05;  ///< of all rows
constexpr int kRings = 3;              ///< of neighbours of changed rows
constexpr int kSweeps = 8;

/// The rows whose diagonal entry changed.
std::vector<bool> ChangedRows(const SparseMatrix& lower, const Eigen::VectorXd& before) {
  const Eigen::VectorXd now = Diagonal(lower);
  std::vector<bool> changed(lower.cols());
  for (int j = 0; j < lower.cols(); ++j) {
    changed[j] = std::abs(now[j] - before[j]) > kChanged * before[j];
  }
  return changed;
}

std::vector<bool> WithNeighbours(const SparseMatrix& lower, const std::vector<bool>& chosen) {
  std::vector<bool> grown = chosen;
  ForEachOffDiagonal(lower, [&](int i, int j, int) {
    if (chosen[i]) grown[j] = true;
    if (chosen[j]) grown[i] = true;
  });
  return grown;
}

}  // namespace

LocalSmoother::LocalSmoother(const SparseMatrix& lower, const Eigen::VectorXd& diagonal_before) {
  if (diagonal_before.size() != lower.cols()) return;
  std::vector<bool> chosen = ChangedRows(lower, diagonal_before);
  const auto count = std::count(chosen.begin(), chosen.end(), true);
  if (count == 0 || static_cast<double>(count) > kMostChanged * static_cast<double>(lower.cols())) {
    return;
  }
  for (int ring = 0; ring < kRings; ++ring) chosen = WithNeighbours(lower, chosen);
  CollectRows(lower, chosen);
}

void LocalSmoother::CollectRows(const SparseMatrix& lower, const std::vector<bool>& chosen) {
  std::vector<int> place(lower.cols(), -1);
  for (int j = 0; j < lower.cols(); ++j) {
    if (!chosen[j]) continue;
    place[j] = num_rows();
    rows_.push_back(j);
    diagonal_.push_back(lower.valuePtr()[lower.outerIndexPtr()[j]]);
  }
  first_.assign(rows_.size() + 1, 0);
  ForEachOffDiagonal(lower, [&](int i, int j, int) {
    if (chosen[i]) ++first_[place[i] + 1];
    if (chosen[j]) ++first_[place[j] + 1];
  });
  for (int k = 0; k < num_rows(); ++k) first_[k + 1] += first_[k];
  entries_.resize(first_.back());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  ForEachOffDiagonal(lower, [&](int i, int j, int p) {
    const double value = lower.valuePtr()[p];
    if (chosen[i]) entries_[next[place[i]]++] = {j, value};
    if (chosen[j]) entries_[next[place[j]]++] = {i, value};
  });
}

void LocalSmoother::Relax(int k, const Eigen::VectorXd& b, Eigen::VectorXd* x) const {
  double rest = b[rows_[k]];
  for (int p = first_[k]; p < first_[k + 1]; ++p) {
    rest -= entries_[p].value * (*x)[entries_[p].column];
  }
  (*x)[rows_[k]] = rest / diagonal_[k];
}

Eigen::VectorXd LocalSmoother::Apply(
    const Eigen::VectorXd& b,
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve) const {
  if (rows_.empty()) return solve(b);
  Eigen::VectorXd near = Eigen::VectorXd::Zero(b.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int k = 0; k < num_rows(); ++k) Relax(k, b, &near);
  }
  Eigen::VectorXd left = b;
  for (int k = 0; k < num_rows(); ++k) {
    left[rows_[k]] -= diagonal_[k] * near[rows_[k]];
    for (int p = first_[k]; p < first_[k + 1]; ++p) {
      left[entries_[p].column] -= entries_[p].value * near[rows_[k]];
    }
  }
  Eigen::VectorXd x = solve(left);
  for (const int j : rows_) x[j] += near[j];
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int k = num_rows(); k-- > 0;) Relax(k, b, &x);
  }
  return x;
}

}  // namespace cirque
