#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/supernodal_factorization.h"

#include <algorithm>
#include <atomic>

#include "cirque/core/parallel.h"
#include "cirque/core/types.h"
#include "cirque/linear/cholmod/column_kernels.h"

namespace cirque {
namespace {

constexpr int kBlockRows = 256;  ///< of a supernode in the top

static_assert(SupernodeBlockNumbers::kTogether == kSolvedTogether);

}  // namespace

/// What one thread at a time works with.
template <class Scalar>
struct SupernodalFactorization<Scalar>::Workspace {
  explicit Workspace(int unknowns) : place(new int[unknowns]) {}

  std::unique_ptr<int[]> place;  ///< per column of the factor, its row in the supernode at work
  std::vector<Descendant> descendants;
  std::vector<Scalar> product;
};

template <class Scalar>
SupernodalFactorization<Scalar>::SupernodalFactorization(const Matrix& lower,
                                                         const cholmod_factor& factor)
    : factor_(factor), tree_(factor), place_in_order_(factor.n) {
  const int* order = static_cast<const int*>(factor.Perm);
  for (int k = 0; k < static_cast<int>(factor.n); ++k) place_in_order_[order[k]] = k;
  ListByRows(lower);
}

template <class Scalar>
void SupernodalFactorization<Scalar>::ListByRows(const Matrix& lower) {
  const int n = static_cast<int>(lower.cols());
  const int *outer = lower.outerIndexPtr(), *inner = lower.innerIndexPtr();
  row_start_.assign(n + 1, 0);
  for (int p = 0; p < outer[n]; ++p) ++row_start_[inner[p] + 1];
  for (int i = 0; i < n; ++i) row_start_[i + 1] += row_start_[i];
  column_.resize(outer[n]);
  entry_.resize(outer[n]);
  std::vector<int> next(row_start_.begin(), row_start_.end() - 1);
  for (int j = 0; j < n; ++j) {
    for (int p = outer[j]; p < outer[j + 1]; ++p) {
      const int slot = next[inner[p]]++;
      column_[slot] = j;
      entry_[slot] = p;
    }
  }
}

template <class Scalar>
DenseTrapezoid<Scalar> SupernodalFactorization<Scalar>::Numbers(int s) const {
  return {static_cast<Scalar*>(factor_.x) + static_cast<const int*>(factor_.px)[s],
          tree_.NumRows(s), tree_.NumColumns(s)};
}

template <class Scalar>
void SupernodalFactorization<Scalar>::TakeDescendants(int s,
                                                      std::vector<Descendant>* descendants) const {
  descendants->clear();
  for (int d = last_waiting_[s]; d != kNone; d = waits_before_[d]) {
    const int* rows = tree_.Rows(d);
    const int* end = std::lower_bound(rows + position_[d], rows + tree_.NumRows(d),
                                      tree_.FirstColumn(s) + tree_.NumColumns(s));
    descendants->push_back({d, position_[d], static_cast<int>(end - rows)});
  }
}

/// The matrix's entries in the columns of s, zeros elsewhere.
template <class Scalar>
void SupernodalFactorization<Scalar>::Fill(const Matrix& lower, int s, int* place) const {
  const int rows = tree_.NumRows(s), columns = tree_.NumColumns(s);
  for (int k = 0; k < rows; ++k) place[tree_.Rows(s)[k]] = k;
  Scalar* numbers = Numbers(s).data;
  std::fill_n(numbers, static_cast<std::size_t>(rows) * columns, Scalar(0));
  const int *outer = lower.outerIndexPtr(), *inner = lower.innerIndexPtr();
  const Scalar* value = lower.valuePtr();
  for (int k = 0; k < columns; ++k, numbers += rows) {
    const int j = tree_.FirstColumn(s) + k;
    const int unknown = static_cast<const int*>(factor_.Perm)[j];
    for (int p = outer[unknown]; p < outer[unknown + 1]; ++p) {
      const int i = place_in_order_[inner[p]];
      if (i >= j) numbers[place[i]] = value[p];
    }
    for (int p = row_start_[unknown]; p < row_start_[unknown + 1]; ++p) {
      const int i = place_in_order_[column_[p]];
      if (i > j) numbers[place[i]] = column::Conjugate(value[entry_[p]]);
    }
  }
}

template <class Scalar>
void SupernodalFactorization<Scalar>::Subtract(const Descendant& of, int s, int first, int last,
                                               const int* place,
                                               std::vector<Scalar>* product) const {
  const int* rows = tree_.Rows(of.d);
  const Scalar* numbers = Numbers(of.d).data;
  const int count = last - first, columns = std::min(of.end, last) - of.begin;
  const std::size_t size = static_cast<std::size_t>(count) * columns;
  if (product->size() < size) product->resize(size);
  Multiply<Scalar>({numbers + first, numbers + of.begin, tree_.NumRows(of.d), count, columns,
                    tree_.NumColumns(of.d)},
                   product->data());
  for (int c = 0; c < columns; ++c) {
    Scalar* target = Numbers(s).data + static_cast<std::size_t>(place[rows[of.begin + c]]) *
                                           static_cast<std::size_t>(tree_.NumRows(s));
    const Scalar* source = product->data() + static_cast<std::size_t>(c) * count - first;
    for (int r = std::max(first, of.begin + c); r < last; ++r) target[place[rows[r]]] -= source[r];
  }
}

template <class Scalar>
void SupernodalFactorization<Scalar>::SubtractInBlocks(int s, const Workspace& work) const {
  const int blocks = (tree_.NumRows(s) + kBlockRows - 1) / kBlockRows;
  ParallelTasks(blocks, [&](int block) {
    const int begin = block * kBlockRows, end = std::min(begin + kBlockRows, tree_.NumRows(s));
    const int first_row = tree_.Rows(s)[begin], last_row = tree_.Rows(s)[end - 1];
    std::vector<Scalar> product;
    for (const Descendant& of : work.descendants) {
      const int *rows = tree_.Rows(of.d), *rows_end = rows + tree_.NumRows(of.d);
      const int* first = std::lower_bound(rows + of.begin, rows_end, first_row);
      const int* last = std::upper_bound(first, rows_end, last_row);
      if (first == last) continue;
      Subtract(of, s, static_cast<int>(first - rows), static_cast<int>(last - rows),
               work.place.get(), &product);
    }
  });
}

template <class Scalar>
void SupernodalFactorization<Scalar>::Pass(int d, int position, std::vector<int>* to_top) {
  position_[d] = position;
  if (position == tree_.NumRows(d)) return;
  const int column = tree_.Rows(d)[position];
  if (to_top && tree_.TopNumber(column) != kNone) return to_top->push_back(d);
  const int s = tree_.SupernodeOf(column);
  waits_before_[d] = last_waiting_[s];
  last_waiting_[s] = d;
}

template <class Scalar>
bool SupernodalFactorization<Scalar>::FactorInSubtree(const Matrix& lower, int s, Workspace* work,
                                                      std::vector<int>* to_top) {
  Fill(lower, s, work->place.get());
  TakeDescendants(s, &work->descendants);
  for (const Descendant& of : work->descendants) {
    Subtract(of, s, of.begin, tree_.NumRows(of.d), work->place.get(), &work->product);
    Pass(of.d, of.end, to_top);
  }
  Pass(s, tree_.NumColumns(s), to_top);
  return FactorTrapezoid(Numbers(s));
}

template <class Scalar>
bool SupernodalFactorization<Scalar>::FactorAtTop(const Matrix& lower, int s, Workspace* work) {
  Fill(lower, s, work->place.get());
  TakeDescendants(s, &work->descendants);
  SubtractInBlocks(s, *work);
  for (const Descendant& of : work->descendants) Pass(of.d, of.end, nullptr);
  Pass(s, tree_.NumColumns(s), nullptr);
  return FactorTrapezoidInParallel(Numbers(s));
}

template <class Scalar>
bool SupernodalFactorization<Scalar>::Compute(const Matrix& lower) {
  last_waiting_.assign(tree_.num_supernodes(), kNone);
  waits_before_.resize(tree_.num_supernodes());
  position_.resize(tree_.num_supernodes());
  const int groups = static_cast<int>(tree_.groups().size());
  std::vector<std::vector<int>> to_top(groups);
  std::atomic<bool> positive = true;
  ParallelTasks(groups, [&](int g) {
    Workspace work(static_cast<int>(factor_.n));
    for (const auto& subtrees : tree_.groups()[g]) {
      for (int s = subtrees.begin; s < subtrees.end && positive; ++s) {
        if (!FactorInSubtree(lower, s, &work, &to_top[g])) positive = false;
      }
    }
  });
  if (!positive) return false;
  for (const std::vector<int>& of_group : to_top) {
    for (const int d : of_group) Pass(d, position_[d], nullptr);
  }
  Workspace work(static_cast<int>(factor_.n));
  return std::all_of(tree_.top_supernodes().begin(), tree_.top_supernodes().end(),
                     [&](int s) { return FactorAtTop(lower, s, &work); });
}

template class SupernodalFactorization<double>;
template class SupernodalFactorization<std::complex<double>>;

void RealSupernodes::Solve(int s, double* w) const { SolveWithTrapezoid(of_.Numbers(s), w); }

void RealSupernodes::SolveTransposed(int s, double* w) const {
  SolveWithTrapezoidTransposed(of_.Numbers(s), w);
}

void RealSupernodes::SolveTogether(int s, double* w) const {
  SolveTogetherWithTrapezoid(of_.Numbers(s), w);
}

void RealSupernodes::SolveTogetherTransposed(int s, double* w) const {
  SolveTogetherWithTrapezoidTransposed(of_.Numbers(s), w);
}

void ComplexSupernodes::Solve(int s, double* w) const {
  SolveWithTrapezoid(of_.Numbers(s), reinterpret_cast<std::complex<double>*>(w));
}

void ComplexSupernodes::SolveTransposed(int s, double* w) const {
  SolveWithTrapezoidTransposed(of_.Numbers(s), reinterpret_cast<std::complex<double>*>(w));
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
