#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "cirque/core/parallel.h"
#include "cirque/linear/registry.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {
namespace {

constexpr int kMaxNeighbours = 3;
constexpr double kLeastKept = 0.38;  ///< share of the unknowns of an angle fit or of the radii
constexpr double kMostNew = 0.2;     ///< share of new unknowns up to which an order is used again

/// Positions of the entries off the diagonal that stand in each row and each column.
class Neighbours {
 public:
  explicit Neighbours(const SparseMatrix& lower) : first_(lower.cols() + 1, 0) {
    ForEachOffDiagonal(lower, [&](int i, int j, int) { ++first_[i + 1], ++first_[j + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    position_.resize(first_.back());
    other_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    ForEachOffDiagonal(lower, [&](int i, int j, int p) {
      other_[next[i]] = j, position_[next[i]++] = p;
      other_[next[j]] = i, position_[next[j]++] = p;
    });
  }

  int begin(int i) const { return first_[i]; }
  int end(int i) const { return first_[i + 1]; }
  int Other(int k) const { return other_[k]; }        ///< the neighbour
  int Position(int k) const { return position_[k]; }  ///< of the entry among the matrix' values

 private:
  std::vector<int> first_, position_, other_;
};

/// An eliminated unknown, its diagonal entry and its couplings to kept unknowns, as positions in
/// the matrix.
struct Eliminated {
  int unknown, diagonal, count = 0;
  std::array<int, kMaxNeighbours> kept = {}, position = {};
};

/// What they are in the matrix that is factored.
struct EliminatedNumbers {
  double inverse = 0;
  std::array<double, kMaxNeighbours> coupling = {};
};

class EliminatingCholesky final : public SparseCholesky {
 public:
  explicit EliminatingCholesky(std::unique_ptr<SparseCholesky> inner) : inner_(std::move(inner)) {}

  void Solve(const Eigen::VectorXd& b, Eigen::VectorXd* x) override {
    reduced_.resize(NumKept());
    Reduce(b.data(), reduced_.data());
    if (!kept_.empty()) inner_->Solve(reduced_, &of_kept_);
    x->resize(b.size());
    Complete(b.data(), of_kept_.data(), x->data());
  }

  void SolveTogether(const Eigen::MatrixXd& b, Eigen::MatrixXd* x) override {
    Eigen::MatrixXd reduced(NumKept(), b.cols()), of_kept;
    for (Eigen::Index c = 0; c < b.cols(); ++c) Reduce(b.col(c).data(), reduced.col(c).data());
    if (!kept_.empty()) inner_->SolveTogether(reduced, &of_kept);
    x->resize(b.rows(), b.cols());
    for (Eigen::Index c = 0; c < b.cols(); ++c) {
      const double* kept = kept_.empty() ? nullptr : of_kept.col(c).data();
      Complete(b.col(c).data(), kept, x->col(c).data());
    }
  }

  void Reserve(int unknowns) override { inner_->Reserve(static_cast<int>(kLeastKept * unknowns)); }

  void KeepInSinglePrecision() override { inner_->KeepInSinglePrecision(); }

 protected:
  bool Analyze(const SparseMatrix& lower) override {
    const std::vector<int> order_before = OrderOfKept();
    {
      const Neighbours neighbours(lower);
      ChooseEliminated(lower, neighbours);
      ListCouplings(neighbours);
    }
    inner_->SuggestOrdering(OrderLike(order_before));
    LayOutComplement();
    return kept_.empty() || inner_->Prepare(complement_);
  }

  bool FactorizeNumerically(const SparseMatrix& lower) override {
    const double* value = lower.valuePtr();
    numbers_.resize(eliminated_.size());
    for (std::size_t k = 0; k < eliminated_.size(); ++k) {
      const Eliminated& e = eliminated_[k];
      if (!(value[e.diagonal] > 0)) return false;
      numbers_[k].inverse = 1 / value[e.diagonal];
      for (int n = 0; n < e.count; ++n) numbers_[k].coupling[n] = value[e.position[n]];
    }
    scaled_.resize(coupling_.size());
    ParallelFor(NumKept(), [&](int j) { FillColumn(lower, j); });
    return kept_.empty() || inner_->Factorize(complement_);
  }

 private:
  /// Of a kept unknown: to a kept one of larger number, or to an eliminated one.
  struct Coupling {
    int other;     ///< its number, or ~(its place among the eliminated)
    int position;  ///< of the entry among the matrix' values
  };

  /// The right side of the kept unknowns.
  void Reduce(const double* b, double* reduced) const {
    ParallelFor(NumKept(), [&](int j) {
      double sum = b[kept_[j]];
      for (int k = first_coupling_[j]; k < first_coupling_[j + 1]; ++k) {
        if (coupling_[k].other < 0) {
          sum -= scaled_[k] * b[eliminated_[~coupling_[k].other].unknown];
        }
      }
      reduced[j] = sum;
    });
  }

  /// All unknowns, given the kept ones.
  void Complete(const double* b, const double* of_kept, double* x) const {
    ParallelFor(NumKept(), [&](int j) { x[kept_[j]] = of_kept[j]; });
    ParallelFor(static_cast<int>(eliminated_.size()), [&](int k) {
      const Eliminated& e = eliminated_[k];
      double rest = b[e.unknown];
      for (int n = 0; n < e.count; ++n) rest -= numbers_[k].coupling[n] * of_kept[e.kept[n]];
      x[e.unknown] = rest * numbers_[k].inverse;
    });
  }

  int NumKept() const { return static_cast<int>(kept_.size()); }

  /// The unknowns that the inner solver eliminated, in its order.
  std::vector<int> OrderOfKept() const {
    std::vector<int> order = inner_->Ordering();
    if (order.size() != kept_.size()) return {};
    for (int& k : order) k = kept_[k];
    return order;
  }

  /// The kept unknowns in an order like one before: active sets change little from step to step,
  /// and to find an order costs as much as to factor. Unknowns that were not kept then, triangles
  /// of few neighbours, come first. Empty when too many are new.
  std::vector<int> OrderLike(const std::vector<int>& order_before) const {
    std::vector<bool> is_old(number_.size(), false);
    for (const int i : order_before) {
      if (i < static_cast<int>(number_.size())) is_old[i] = true;
    }
    std::vector<int> order;
    order.reserve(kept_.size());
    for (int k = 0; k < NumKept(); ++k) {
      if (!is_old[kept_[k]]) order.push_back(k);
    }
    if (static_cast<double>(order.size()) > kMostNew * NumKept()) return {};
    for (const int i : order_before) {
      if (i < static_cast<int>(number_.size()) && number_[i] >= 0) order.push_back(number_[i]);
    }
    return order;
  }

  void ChooseEliminated(const SparseMatrix& lower, const Neighbours& neighbours) {
    const int n = static_cast<int>(lower.cols());
    std::vector<bool> must_stay(n, false);
    number_.resize(n);
    kept_.clear();
    eliminated_.clear();
    eliminated_.reserve(n);  // pages beyond the last one are never touched
    for (int i = 0; i < n; ++i) {
      const int degree = neighbours.end(i) - neighbours.begin(i);
      if (must_stay[i] || degree > kMaxNeighbours) {
        number_[i] = NumKept();
        kept_.push_back(i);
        continue;
      }
      Eliminated e{i, lower.outerIndexPtr()[i], degree};
      for (int k = 0; k < degree; ++k) {
        must_stay[neighbours.Other(neighbours.begin(i) + k)] = true;
        e.kept[k] = neighbours.Other(neighbours.begin(i) + k);
        e.position[k] = neighbours.Position(neighbours.begin(i) + k);
      }
      number_[i] = ~static_cast<int>(eliminated_.size());
      eliminated_.push_back(e);
    }
    for (Eliminated& e : eliminated_) {
      for (int k = 0; k < e.count; ++k) e.kept[k] = number_[e.kept[k]];
    }
  }

  void ListCouplings(const Neighbours& neighbours) {
    first_coupling_.assign(1, 0);
    coupling_.clear();
    coupling_.reserve(3 * eliminated_.size());
    for (int j = 0; j < NumKept(); ++j) {
      for (int k = neighbours.begin(kept_[j]); k < neighbours.end(kept_[j]); ++k) {
        const int other = number_[neighbours.Other(k)];
        if (other < 0 || other > j) coupling_.push_back({other, neighbours.Position(k)});
      }
      first_coupling_.push_back(static_cast<int>(coupling_.size()));
    }
  }

  /// The rows of a column of the complement, increasing.
  void FindRows(int j, std::vector<int>* rows) const {
    rows->assign(1, j);
    for (int k = first_coupling_[j]; k < first_coupling_[j + 1]; ++k) {
      const int other = coupling_[k].other;
      if (other >= 0) {
        rows->push_back(other);
        continue;
      }
      const Eliminated& e = eliminated_[~other];
      for (int n = 0; n < e.count; ++n) {
        if (e.kept[n] > j) rows->push_back(e.kept[n]);
      }
    }
    std::sort(rows->begin(), rows->end());
    rows->erase(std::unique(rows->begin(), rows->end()), rows->end());
  }

  void LayOutComplement() {
    complement_.resize(NumKept(), NumKept());
    int* start = complement_.outerIndexPtr();
    start[0] = 0;
    std::vector<std::vector<int>> rows_of_block(NumBlocks(NumKept()));
    ForEachBlock(NumKept(), [&](int block, int begin, int end) {
      std::vector<int> rows;
      for (int j = begin; j < end; ++j) {
        FindRows(j, &rows);
        start[j + 1] = static_cast<int>(rows.size());
        rows_of_block[block].insert(rows_of_block[block].end(), rows.begin(), rows.end());
      }
    });
    for (int j = 0; j < NumKept(); ++j) start[j + 1] += start[j];
    complement_.resizeNonZeros(start[NumKept()]);
    ForEachBlock(NumKept(), [&](int block, int begin, int) {
      const std::vector<int>& rows = rows_of_block[block];
      std::copy(rows.begin(), rows.end(), complement_.innerIndexPtr() + start[begin]);
    });
  }

  void FillColumn(const SparseMatrix& lower, int j) {
    const double* value = lower.valuePtr();
    const int* rows = complement_.innerIndexPtr() + complement_.outerIndexPtr()[j];
    const int count = complement_.outerIndexPtr()[j + 1] - complement_.outerIndexPtr()[j];
    double* column = complement_.valuePtr() + complement_.outerIndexPtr()[j];
    const auto add = [&](int i, double x) {
      column[std::lower_bound(rows, rows + count, i) - rows] += x;
    };
    std::fill_n(column, count, 0.0);
    add(j, DiagonalEntry(lower, kept_[j]));
    for (int k = first_coupling_[j]; k < first_coupling_[j + 1]; ++k) {
      const auto [other, position] = coupling_[k];
      if (other >= 0) {
        add(other, value[position]);
        continue;
      }
      const Eliminated& e = eliminated_[~other];
      const EliminatedNumbers& numbers = numbers_[~other];
      scaled_[k] = value[position] * numbers.inverse;
      for (int n = 0; n < e.count; ++n) {
        if (e.kept[n] >= j) add(e.kept[n], -scaled_[k] * numbers.coupling[n]);
      }
    }
  }

  std::unique_ptr<SparseCholesky> inner_;
  std::vector<int> number_;  ///< per unknown: among the kept, or ~(place among the eliminated)
  std::vector<int> kept_;    ///< the unknowns that stay, in increasing order
  std::vector<Eliminated> eliminated_;
  std::vector<EliminatedNumbers> numbers_;  ///< of each of them
  std::vector<int> first_coupling_;         ///< per kept unknown: where its couplings begin
  std::vector<Coupling> coupling_;
  std::vector<double> scaled_;  ///< to eliminated ones: the entry over the eliminated's diagonal
  SparseMatrix complement_;
  Eigen::VectorXd reduced_, of_kept_;  ///< a right side and its solution
};

}  // namespace

std::unique_ptr<SparseCholesky> MakeEliminatingCholesky(std::unique_ptr<SparseCholesky> inner) {
  return std::make_unique<EliminatingCholesky>(std::move(inner));
}

}  // namespace cirque
