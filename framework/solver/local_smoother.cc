#include "cirque/solver/local_smoother.h"

#include <algorithm>
#include <cmath>

#include "cirque/core/parallel.h"
#include "cirque/solver/lower_triangle.h"

namespace cirque {

namespace {

constexpr double kChanged = 0.05;      ///< of a diagonal entry
constexpr double kMostChanged = 0.05;  ///< of all rows
constexpr int kRings = 3;              ///< of neighbours of changed rows
constexpr int kSweeps = 8;

/// The rows whose diagonal entry changed.
std::vector<char> ChangedRows(const SparseMatrix& lower, const Eigen::VectorXd& before) {
  std::vector<char> changed(lower.cols());
  ParallelFor(static_cast<int>(lower.cols()), [&](int j) {
    changed[j] = std::abs(DiagonalEntry(lower, j) - before[j]) > kChanged * before[j];
  });
  return changed;
}

std::vector<char> WithNeighbours(const SparseMatrix& lower, const std::vector<char>& chosen) {
  std::vector<char> grown = chosen;
  const int n = static_cast<int>(lower.cols());
  ParallelFor(n, [&](int j) {
    ForEachBelowDiagonal(lower, j, [&](int i, int) { grown[j] = grown[j] || chosen[i]; });
  });
  for (int j = 0; j < n; ++j) {
    if (chosen[j]) ForEachBelowDiagonal(lower, j, [&](int i, int) { grown[i] = true; });
  }
  return grown;
}

struct Coupling {
  int i, j;
  double value;
};

/// Those of chosen rows, block by block of columns.
std::vector<std::vector<Coupling>> CouplingsOf(const SparseMatrix& lower,
                                               const std::vector<char>& chosen) {
  const int n = static_cast<int>(lower.cols());
  std::vector<std::vector<Coupling>> couplings(NumBlocks(n));
  ForEachBlock(n, [&](int block, int begin, int end) {
    for (int j = begin; j < end; ++j) {
      ForEachBelowDiagonal(lower, j, [&](int i, int p) {
        if (chosen[i] || chosen[j]) couplings[block].push_back({i, j, lower.valuePtr()[p]});
      });
    }
  });
  return couplings;
}

template <class Visit>
void ForEach(const std::vector<std::vector<Coupling>>& couplings, const Visit& visit) {
  for (const std::vector<Coupling>& of_block : couplings) {
    for (const Coupling& c : of_block) visit(c);
  }
}

}  // namespace

LocalSmoother::LocalSmoother(const SparseMatrix& lower, const Eigen::VectorXd& diagonal_before) {
  if (diagonal_before.size() != lower.cols()) return;
  std::vector<char> chosen = ChangedRows(lower, diagonal_before);
  const auto count = std::count(chosen.begin(), chosen.end(), true);
  if (count == 0 || static_cast<double>(count) > kMostChanged * static_cast<double>(lower.cols())) {
    return;
  }
  for (int ring = 0; ring < kRings; ++ring) chosen = WithNeighbours(lower, chosen);
  CollectRows(lower, chosen);
}

void LocalSmoother::CollectRows(const SparseMatrix& lower, const std::vector<char>& chosen) {
  const int n = static_cast<int>(lower.cols());
  std::vector<int> place(n, -1);
  for (int j = 0; j < n; ++j) {
    if (!chosen[j]) continue;
    place[j] = num_rows();
    rows_.push_back(j);
    diagonal_.push_back(DiagonalEntry(lower, j));
  }
  first_.assign(rows_.size() + 1, 0);
  const std::vector<std::vector<Coupling>> couplings = CouplingsOf(lower, chosen);
  ForEach(couplings, [&](const Coupling& c) {
    if (chosen[c.i]) ++first_[place[c.i] + 1];
    if (chosen[c.j]) ++first_[place[c.j] + 1];
  });
  for (int k = 0; k < num_rows(); ++k) first_[k + 1] += first_[k];
  entries_.resize(first_.back());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  ForEach(couplings, [&](const Coupling& c) {
    if (chosen[c.i]) entries_[next[place[c.i]]++] = {c.j, c.value};
    if (chosen[c.j]) entries_[next[place[c.j]]++] = {c.i, c.value};
  });
}

void LocalSmoother::Relax(int k, const Eigen::VectorXd& b, Eigen::VectorXd* x) const {
  double rest = b[rows_[k]];
  for (int p = first_[k]; p < first_[k + 1]; ++p) {
    rest -= entries_[p].value * (*x)[entries_[p].column];
  }
  (*x)[rows_[k]] = rest / diagonal_[k];
}

void LocalSmoother::Apply(const Eigen::VectorXd& b, const Preconditioner& solve,
                          Eigen::VectorXd* x) {
  if (rows_.empty()) return solve(b, x);
  if (near_.size() != b.size()) near_.setZero(b.size());
  for (const int j : rows_) near_[j] = 0;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int k = 0; k < num_rows(); ++k) Relax(k, b, &near_);
  }
  left_.resize(b.size());
  ParallelFor(static_cast<int>(b.size()), [&](int j) { left_[j] = b[j]; });
  for (int k = 0; k < num_rows(); ++k) {
    left_[rows_[k]] -= diagonal_[k] * near_[rows_[k]];
    for (int p = first_[k]; p < first_[k + 1]; ++p) {
      left_[entries_[p].column] -= entries_[p].value * near_[rows_[k]];
    }
  }
  solve(left_, x);
  for (const int j : rows_) (*x)[j] += near_[j];
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (int k = num_rows(); k-- > 0;) Relax(k, b, x);
  }
}

}  // namespace cirque
