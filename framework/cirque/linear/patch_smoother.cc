#include "cirque/linear/patch_smoother.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {

namespace {

constexpr double kChanged = 0.05;      ///< of a diagonal entry
constexpr double kMostChanged = 0.05;  ///< of all rows
constexpr int kRings = 2;              ///< of neighbours of changed rows
constexpr int kSweeps = 4;
constexpr int kTasks = 16;

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

/// The chosen rows, increasing, in pieces that are not coupled.
Buckets UncoupledPieces(const std::vector<char>& chosen,
                        const std::vector<std::vector<Coupling>>& couplings) {
  std::vector<int> row, number(chosen.size(), kNone);
  for (int j = 0; j < static_cast<int>(chosen.size()); ++j) {
    if (!chosen[j]) continue;
    number[j] = static_cast<int>(row.size());
    row.push_back(j);
  }
  DisjointSets sets(static_cast<int>(row.size()));
  ForEach(couplings, [&](const Coupling& c) {
    if (chosen[c.i] && chosen[c.j]) sets.Unite(number[c.i], number[c.j]);
  });
  int pieces = 0;
  std::vector<int> piece(row.size());  // the representative of a set is its least element
  for (int k = 0; k < static_cast<int>(row.size()); ++k) {
    piece[k] = sets.Find(k) == k ? pieces++ : piece[sets.Find(k)];
  }
  Buckets rows = SortIntoBuckets(piece, pieces);
  for (int& k : rows.item) k = row[k];
  return rows;
}

}  // namespace

PatchSmoother::PatchSmoother(const SparseMatrix& lower, const Eigen::VectorXd& diagonal_before) {
  if (diagonal_before.size() != lower.cols()) return;
  std::vector<char> chosen = ChangedRows(lower, diagonal_before);
  const auto count = std::count(chosen.begin(), chosen.end(), true);
  if (count == 0 || static_cast<double>(count) > kMostChanged * static_cast<double>(lower.cols())) {
    return;
  }
  for (int ring = 0; ring < kRings; ++ring) chosen = WithNeighbours(lower, chosen);
  CollectRows(lower, chosen);
}

void PatchSmoother::CollectRows(const SparseMatrix& lower, const std::vector<char>& chosen) {
  const std::vector<std::vector<Coupling>> couplings = CouplingsOf(lower, chosen);
  Buckets pieces = UncoupledPieces(chosen, couplings);
  rows_ = std::move(pieces.item);
  piece_ = std::move(pieces.first);
  std::vector<int> place(lower.cols());
  for (int k = 0; k < num_rows(); ++k) {
    place[rows_[k]] = k;
    diagonal_.push_back(DiagonalEntry(lower, rows_[k]));
  }
  first_.assign(rows_.size() + 1, 0);
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

void PatchSmoother::Relax(int k, const Eigen::VectorXd& b, Eigen::VectorXd* x) const {
  double rest = b[rows_[k]];
  for (int p = first_[k]; p < first_[k + 1]; ++p) {
    rest -= entries_[p].value * (*x)[entries_[p].column];
  }
  (*x)[rows_[k]] = rest / diagonal_[k];
}

void PatchSmoother::ForEachPiece(const std::function<void(int, int)>& body) const {
  // Tasks of about equal numbers of rows.
  ParallelTasks(kTasks, [&](int task) {
    const auto first_from = [&](int part) {
      const auto row = static_cast<int>(static_cast<long long>(num_rows()) * part / kTasks);
      return std::lower_bound(piece_.begin(), piece_.end(), row);
    };
    for (auto p = first_from(task); p != first_from(task + 1); ++p) body(*p, *(p + 1));
  });
}

void PatchSmoother::SweepForward(const Eigen::VectorXd& b, Eigen::VectorXd* swept,
                                 Eigen::VectorXd* left) const {
  ForEachPiece([&](int begin, int end) {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (int k = begin; k < end; ++k) Relax(k, b, swept);
    }
  });
  for (int k = 0; k < num_rows(); ++k) {
    const double x = (*swept)[rows_[k]];
    (*left)[rows_[k]] -= diagonal_[k] * x;
    for (int p = first_[k]; p < first_[k + 1]; ++p) {
      (*left)[entries_[p].column] -= entries_[p].value * x;
    }
  }
}

void PatchSmoother::SweepBackward(const Eigen::VectorXd& b, Eigen::VectorXd* x) const {
  ForEachPiece([&](int begin, int end) {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (int k = end; k-- > begin;) Relax(k, b, x);
    }
  });
}

void PatchSmoother::Apply(const Eigen::VectorXd& b, const Preconditioner& solve,
                          Eigen::VectorXd* x) {
  if (rows_.empty()) return solve(b, x);
  if (near_.size() != b.size()) near_.setZero(b.size());
  for (const int row : rows_) near_[row] = 0;
  left_.resize(b.size());
  ParallelFor(static_cast<int>(b.size()), [&](int j) { left_[j] = b[j]; });
  SweepForward(b, &near_, &left_);
  solve(left_, x);
  for (const int row : rows_) (*x)[row] += near_[row];
  SweepBackward(b, x);
}

Preconditioner PatchSmoother::Around(Preconditioner solve) {
  return [this, solve = std::move(solve)](const Eigen::VectorXd& b, Eigen::VectorXd* x) {
    Apply(b, solve, x);
  };
}

}  // namespace cirque
