#include "cirque/linear/halo.h"

#include <algorithm>
#include <cstddef>

#include "cirque/core/parallel.h"

namespace cirque {
namespace {

/// Where the ghosts of each rank begin.
std::vector<int> FirstGhosts(const RankUnknowns& unknowns) {
  std::vector<int> first;
  for (const int number : unknowns.first) {
    const auto& ghosts = unknowns.ghosts;
    const auto place = std::lower_bound(ghosts.begin(), ghosts.end(), number);
    first.push_back(static_cast<int>(place - ghosts.begin()));
  }
  return first;
}

/// Calls visit(to, from) for all pairs of ranks that this one exchanges with, in an order in which
/// nobody waits for who waits for him.
template <class Visit>
void ForEachExchange(const Ranks& ranks, const Visit& visit) {
  const int count = ranks.num_ranks();
  for (int shift = 1; shift < count; ++shift) {
    visit((ranks.rank() + shift) % count, (ranks.rank() - shift + count) % count);
  }
}

}  // namespace

Halo::Halo(Ranks* ranks, const RankUnknowns& unknowns)
    : ranks_(*ranks),
      num_own_(unknowns.first[ranks->rank() + 1] - unknowns.first[ranks->rank()]),
      first_ghost_(FirstGhosts(unknowns)),
      sent_(ranks->num_ranks()) {
  ForEachExchange(ranks_, [&](int to, int from) {
    const int asked = first_ghost_[to + 1] - first_ghost_[to];
    int wanted = 0;
    ranks_.SendReceive(to, &asked, sizeof(int), from, &wanted, sizeof(int));
    sent_[from].resize(wanted);
    ranks_.SendReceive(to, unknowns.ghosts.data() + first_ghost_[to], asked * sizeof(int), from,
                       sent_[from].data(), wanted * sizeof(int));
    for (int& number : sent_[from]) number -= unknowns.first[ranks_.rank()];
  });
}

template <class T>
void Halo::FillArray(T* local) const {
  std::vector<T> values;
  ForEachExchange(ranks_, [&](int to, int from) {
    values.clear();
    for (const int k : sent_[to]) values.push_back(local[k]);
    const std::size_t count = first_ghost_[from + 1] - first_ghost_[from];
    ranks_.SendReceive(to, values.data(), values.size() * sizeof(T), from,
                       local + num_own_ + first_ghost_[from], count * sizeof(T));
  });
}

template void Halo::FillArray(int* local) const;
template void Halo::FillArray(double* local) const;

Eigen::VectorXd LocalRows::Times(const Eigen::VectorXd& x) const {
  Eigen::VectorXd product(num_rows());
  ParallelFor(num_rows(), [&](int row) {
    double sum = 0;
    for (int k = start[row]; k < start[row + 1]; ++k) sum += value[k] * x[column[k]];
    product[row] = sum;
  });
  return product;
}

LocalRows OwnRows(const SparseMatrix& lower, const std::vector<int>& slot, int num_own) {
  LocalRows rows;
  rows.start.assign(num_own + 1, 0);
  for (const int row : slot) {
    if (row < num_own) ++rows.start[row + 1];
  }
  const auto for_each = [&](const auto& visit) {
    ForEachOffDiagonal(lower, [&](int i, int j, int p) {
      if (slot[i] < num_own) visit(slot[i], slot[j], lower.valuePtr()[p]);
      if (slot[j] < num_own) visit(slot[j], slot[i], lower.valuePtr()[p]);
    });
  };
  for_each([&](int row, int, double) { ++rows.start[row + 1]; });
  for (int i = 0; i < num_own; ++i) rows.start[i + 1] += rows.start[i];
  rows.column.resize(rows.start.back());
  rows.value.resize(rows.start.back());
  std::vector<int> next(rows.start.begin(), rows.start.end() - 1);
  const auto add = [&](int row, int column, double value) {
    rows.column[next[row]] = column;
    rows.value[next[row]++] = value;
  };
  for (int j = 0; j < static_cast<int>(slot.size()); ++j) {
    if (slot[j] < num_own) add(slot[j], slot[j], DiagonalEntry(lower, j));
  }
  for_each(add);
  return rows;
}

}  // namespace cirque
