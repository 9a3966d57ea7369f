#ifdef CIRQUE_CHOLMOD

#include "cirque/solver/single_precision_factor.h"

#include <algorithm>

#include "cirque/core/parallel.h"
#include "cirque/solver/supernode_tiles.h"

namespace cirque {
namespace {

constexpr int kSlices = 16;                                   ///< that are rounded at once
constexpr double kLeastPivot = 1e-18, kLargestNumber = 1e18;  ///< their squares are single too

SupernodeTiles TilesOf(const SupernodalTree& tree, int s) {
  return {tree.NumRows(s), tree.NumColumns(s)};
}

}  // namespace

std::unique_ptr<SinglePrecisionFactor> SinglePrecisionFactor::Round(const cholmod_factor& factor) {
  std::unique_ptr<SinglePrecisionFactor> rounded(new SinglePrecisionFactor(factor));
  if (!rounded->CanRound()) return nullptr;
  rounded->RoundInPlace();
  return rounded;
}

SinglePrecisionFactor::SinglePrecisionFactor(const cholmod_factor& factor)
    : factor_(factor), tree_(factor), start_(1, 0), x_(factor.n), far_(tree_.groups().size()) {
  for (int s = 0; s < tree_.num_supernodes(); ++s) {
    start_.push_back(start_.back() + TilesOf(tree_, s).Size());
  }
  work_.assign(far_.size(), Eigen::VectorXd(SupernodeTiles(tree_.most_rows(), 0).NumPadded()));
}

const double* SinglePrecisionFactor::Doubles(int s) const {
  return static_cast<const double*>(factor_.x) + static_cast<const int*>(factor_.px)[s];
}

bool SinglePrecisionFactor::CanRound() const {
  for (int s = 0; s < tree_.num_supernodes(); ++s) {
    const Eigen::Map<const Eigen::MatrixXd> numbers(Doubles(s), tree_.NumRows(s),
                                                    tree_.NumColumns(s));
    if (!(numbers.diagonal().minCoeff() > kLeastPivot)) return false;
    if (!(numbers.lpNorm<Eigen::Infinity>() < kLargestNumber)) return false;
    if (2 * (Doubles(s + 1) - Doubles(0)) < static_cast<std::ptrdiff_t>(start_[s + 1]))
      return false;
  }
  return true;
}

void SinglePrecisionFactor::RoundInPlace() {
  float* const singles = static_cast<float*>(factor_.x);
  const auto round = [&](int begin, int end) {
    for (int s = begin; s < end; ++s) TilesOf(tree_, s).Store(Doubles(s), singles + start_[s]);
  };
  for (int begin = 0, end; begin < tree_.num_supernodes(); begin = end) {
    end = EndOfFree(begin);
    const int slice = (end - begin) / kSlices;
    if (slice > 0) {
      ParallelTasks(kSlices, [&](int k) { round(begin + k * slice, begin + (k + 1) * slice); });
    }
    round(begin + kSlices * slice, end);
  }
}

int SinglePrecisionFactor::EndOfFree(int begin) const {
  const std::size_t room = 2 * (Doubles(begin) - Doubles(0));
  const auto past = std::upper_bound(start_.begin() + begin, start_.end(), room);
  return std::max(begin + 1, static_cast<int>(past - start_.begin()) - 1);
}

void SinglePrecisionFactor::Forward(int s, double* x, double* far, Eigen::VectorXd* work) const {
  const int rows = tree_.NumRows(s), columns = tree_.NumColumns(s);
  const SupernodeTiles tiles(rows, columns);
  double* w = work->data();
  std::copy_n(x + tree_.FirstColumn(s), columns, w);
  std::fill(w + columns, w + tiles.NumPadded(), 0.0);
  tiles.Solve(Singles(s), w);
  std::copy_n(w, columns, x + tree_.FirstColumn(s));
  const int* row = tree_.Rows(s);
  const int near = tree_.NumNear(s);
  for (int k = columns; k < near; ++k) x[row[k]] += w[k];
  for (int k = near; k < rows; ++k) far[tree_.TrunkNumber(row[k])] += w[k];
}

void SinglePrecisionFactor::Backward(int s, double* x, Eigen::VectorXd* work) const {
  const int rows = tree_.NumRows(s), columns = tree_.NumColumns(s);
  const SupernodeTiles tiles(rows, columns);
  double* w = work->data();
  std::copy_n(x + tree_.FirstColumn(s), columns, w);
  const int* row = tree_.Rows(s);
  for (int k = columns; k < rows; ++k) w[k] = x[row[k]];
  std::fill(w + rows, w + tiles.NumPadded(), 0.0);
  tiles.SolveTransposed(Singles(s), w);
  std::copy_n(w, columns, x + tree_.FirstColumn(s));
}

void SinglePrecisionFactor::ForwardAll() {
  const auto& trunk_columns = tree_.trunk_columns();
  ParallelTasks(static_cast<int>(far_.size()), [&](int g) {
    far_[g].setZero(trunk_columns.size());
    for (const auto& branches : tree_.groups()[g]) {
      for (int s = branches.begin; s < branches.end; ++s) {
        Forward(s, x_.data(), far_[g].data(), &work_[g]);
      }
    }
  });
  for (const Eigen::VectorXd& of_group : far_) {
    for (std::size_t k = 0; k < trunk_columns.size(); ++k) x_[trunk_columns[k]] += of_group[k];
  }
  for (const int s : tree_.trunk()) Forward(s, x_.data(), nullptr, &work_.front());
}

void SinglePrecisionFactor::BackwardAll() {
  for (auto s = tree_.trunk().rbegin(); s != tree_.trunk().rend(); ++s) {
    Backward(*s, x_.data(), &work_.front());
  }
  ParallelTasks(static_cast<int>(work_.size()), [&](int g) {
    const auto& group = tree_.groups()[g];
    for (auto branches = group.rbegin(); branches != group.rend(); ++branches) {
      for (int s = branches->end; s-- > branches->begin;) Backward(s, x_.data(), &work_[g]);
    }
  });
}

void SinglePrecisionFactor::Solve(const Eigen::VectorXd& b, Eigen::VectorXd* x) {
  const int n = static_cast<int>(factor_.n);
  const int* order = static_cast<const int*>(factor_.Perm);
  ParallelFor(n, [&](int k) { x_[k] = b[order[k]]; });
  ForwardAll();
  BackwardAll();
  x->resize(n);
  ParallelFor(n, [&](int k) { (*x)[order[k]] = x_[k]; });
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
