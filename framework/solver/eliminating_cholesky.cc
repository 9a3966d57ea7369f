#include "cirque/solver/eliminating_cholesky.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace cirque {
namespace {

constexpr int kMaxNeighbours = 3;
constexpr int kEliminated = -1;
constexpr double kMostNew = 0.2;  ///< share of new unknowns up to which an order is used again

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

  template <class Visit>
  static void ForEachOffDiagonal(const SparseMatrix& lower, const Visit& visit) {
    for (int j = 0; j < lower.cols(); ++j) {
      for (int p = lower.outerIndexPtr()[j]; p < lower.outerIndexPtr()[j + 1]; ++p) {
        if (lower.innerIndexPtr()[p] != j) visit(lower.innerIndexPtr()[p], j, p);
      }
    }
  }

 private:
  std::vector<int> first_, position_, other_;
};

/// An eliminated unknown: its diagonal entry and its couplings to kept unknowns, as positions in
/// the matrix, then as numbers.
struct Eliminated {
  int unknown, diagonal, count = 0;
  std::array<int, kMaxNeighbours> kept = {}, position = {};
  double inverse = 0;
  std::array<double, kMaxNeighbours> coupling = {};
};

class EliminatingCholesky final : public SparseCholesky {
 public:
  explicit EliminatingCholesky(std::unique_ptr<SparseCholesky> inner) : inner_(std::move(inner)) {}

  Eigen::VectorXd Solve(const Eigen::VectorXd& right_side) override {
    Eigen::VectorXd reduced(static_cast<Eigen::Index>(kept_.size()));
    for (std::size_t k = 0; k < kept_.size(); ++k) reduced[k] = right_side[kept_[k]];
    for (const Eliminated& e : eliminated_) {
      const double share = right_side[e.unknown] * e.inverse;
      for (int n = 0; n < e.count; ++n) reduced[e.kept[n]] -= e.coupling[n] * share;
    }
    const Eigen::VectorXd of_kept = kept_.empty() ? reduced : inner_->Solve(reduced);
    Eigen::VectorXd x(right_side.size());
    for (std::size_t k = 0; k < kept_.size(); ++k) x[kept_[k]] = of_kept[k];
    for (const Eliminated& e : eliminated_) {
      double rest = right_side[e.unknown];
      for (int n = 0; n < e.count; ++n) rest -= e.coupling[n] * of_kept[e.kept[n]];
      x[e.unknown] = rest * e.inverse;
    }
    return x;
  }

 protected:
  bool Analyze(const SparseMatrix& lower) override {
    const std::vector<int> order_before = OrderOfKept();
    const Neighbours neighbours(lower);
    ChooseEliminated(lower, neighbours);
    inner_->SuggestOrdering(OrderLike(order_before));
    LayOutComplement(lower);
    return kept_.empty() || inner_->Prepare(complement_);
  }

  bool FactorizeNumerically(const SparseMatrix& lower) override {
    const double* value = lower.valuePtr();
    std::fill_n(complement_.valuePtr(), complement_.nonZeros(), 0.0);
    std::size_t next = 0;
    const auto add = [&](double x) { complement_.valuePtr()[slot_[next++]] += x; };
    for (const int p : kept_entry_) add(value[p]);
    for (Eliminated& e : eliminated_) {
      if (!(value[e.diagonal] > 0)) return false;
      e.inverse = 1 / value[e.diagonal];
      for (int n = 0; n < e.count; ++n) e.coupling[n] = value[e.position[n]];
      for (int n = 0; n < e.count; ++n) {
        for (int m = 0; m <= n; ++m) add(-e.coupling[n] * e.coupling[m] * e.inverse);
      }
    }
    return kept_.empty() || inner_->Factorize(complement_);
  }

 private:
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
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      if (!is_old[kept_[k]]) order.push_back(static_cast<int>(k));
    }
    if (order.size() > kMostNew * static_cast<double>(kept_.size())) return {};
    for (const int i : order_before) {
      if (i < static_cast<int>(number_.size()) && number_[i] != kEliminated) {
        order.push_back(number_[i]);
      }
    }
    return order;
  }

  void ChooseEliminated(const SparseMatrix& lower, const Neighbours& neighbours) {
    const int n = static_cast<int>(lower.cols());
    std::vector<bool> must_stay(n, false);
    number_.assign(n, kEliminated);
    kept_.clear();
    eliminated_.clear();
    for (int i = 0; i < n; ++i) {
      const int degree = neighbours.end(i) - neighbours.begin(i);
      if (must_stay[i] || degree > kMaxNeighbours) {
        number_[i] = static_cast<int>(kept_.size());
        kept_.push_back(i);
        continue;
      }
      Eliminated e{i, lower.outerIndexPtr()[i], degree};
      for (int k = 0; k < degree; ++k) {
        must_stay[neighbours.Other(neighbours.begin(i) + k)] = true;
        e.kept[k] = neighbours.Other(neighbours.begin(i) + k);
        e.position[k] = neighbours.Position(neighbours.begin(i) + k);
      }
      eliminated_.push_back(e);
    }
    for (Eliminated& e : eliminated_) {
      for (int k = 0; k < e.count; ++k) e.kept[k] = number_[e.kept[k]];
    }
  }

  /// The complement's pattern, and for every number that FactorizeNumerically adds its slot there.
  void LayOutComplement(const SparseMatrix& lower) {
    std::vector<std::array<int, 2>> entry;  // row and column, in the order of the additions
    const auto add = [&](int i, int j) { entry.push_back({std::max(i, j), std::min(i, j)}); };
    kept_entry_.clear();
    for (const int j : kept_) {
      for (int p = lower.outerIndexPtr()[j]; p < lower.outerIndexPtr()[j + 1]; ++p) {
        const int i = number_[lower.innerIndexPtr()[p]];
        if (i == kEliminated) continue;
        kept_entry_.push_back(p);
        add(i, number_[j]);
      }
    }
    for (const Eliminated& e : eliminated_) {
      for (int n = 0; n < e.count; ++n) {
        for (int m = 0; m <= n; ++m) add(e.kept[n], e.kept[m]);
      }
    }
    Compress(entry);
  }

  /// Sorts the entries by column, then by row, and gives equal ones one slot.
  void Compress(const std::vector<std::array<int, 2>>& entry) {
    const int n = static_cast<int>(kept_.size());
    std::vector<int> first(n + 1, 0), in_column(entry.size());
    for (const auto& [i, j] : entry) ++first[j + 1];
    for (int j = 0; j < n; ++j) first[j + 1] += first[j];
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t k = 0; k < entry.size(); ++k) {
      in_column[next[entry[k][1]]++] = static_cast<int>(k);
    }
    slot_.resize(entry.size());
    std::vector<int> start(n + 1, 0), row;
    row.reserve(entry.size() / 2);
    for (int j = 0; j < n; ++j) {
      const auto begin = in_column.begin() + first[j], end = in_column.begin() + first[j + 1];
      std::sort(begin, end, [&](int a, int b) { return entry[a][0] < entry[b][0]; });
      for (auto k = begin; k != end; ++k) {
        if (k == begin || entry[*k][0] != row.back()) row.push_back(entry[*k][0]);
        slot_[*k] = static_cast<int>(row.size()) - 1;
      }
      start[j + 1] = static_cast<int>(row.size());
    }
    complement_.resize(n, n);
    complement_.resizeNonZeros(static_cast<Eigen::Index>(row.size()));
    std::copy(start.begin(), start.end(), complement_.outerIndexPtr());
    std::copy(row.begin(), row.end(), complement_.innerIndexPtr());
  }

  std::unique_ptr<SparseCholesky> inner_;
  std::vector<int> number_;  ///< per unknown: among the kept, or kEliminated
  std::vector<int> kept_;    ///< the unknowns that stay, in increasing order
  std::vector<Eliminated> eliminated_;
  std::vector<int> kept_entry_;  ///< positions of the matrix' entries between kept unknowns
  std::vector<int> slot_;        ///< where each addition goes in the complement's values
  SparseMatrix complement_;
};

}  // namespace

std::unique_ptr<SparseCholesky> MakeEliminatingCholesky(std::unique_ptr<SparseCholesky> inner) {
  return std::make_unique<EliminatingCholesky>(std::move(inner));
}

}  // namespace cirque
