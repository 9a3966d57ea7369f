#include "cirque/linear/local_elimination.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cirque {

LocalElimination::LocalElimination(const LocalRows& rows, const Halo& halo) {
  Choose(rows);
  NumberKept(halo);
}

void LocalElimination::Choose(const LocalRows& rows) {
  const int n = rows.num_rows();
  std::vector<bool> must_stay(n, false);
  place_.resize(n);
  for (int i = 0; i < n; ++i) {
    const int begin = rows.start[i] + 1, end = rows.start[i + 1];
    const bool stays = must_stay[i] || end - begin > kMaxNeighbours ||
                       std::any_of(rows.column.begin() + begin, rows.column.begin() + end,
                                   [&](int j) { return j >= n; });
    if (stays) {
      place_[i] = num_kept();
      kept_.push_back(i);
      continue;
    }
    Eliminated e{i, end - begin};
    for (int k = 0; k < e.count; ++k) {
      e.kept[k] = rows.column[begin + k];
      must_stay[e.kept[k]] = true;
    }
    place_[i] = ~static_cast<int>(eliminated_.size());
    eliminated_.push_back(e);
  }
  kept_.shrink_to_fit();
  eliminated_.shrink_to_fit();
  for (Eliminated& e : eliminated_) {
    for (int k = 0; k < e.count; ++k) e.kept[k] = place_[e.kept[k]];
  }
}

void LocalElimination::NumberKept(const Halo& halo) {
  const std::vector<int> counts = halo.ranks().AllOf(num_kept());
  const int rank = halo.ranks().rank();
  const int first = std::accumulate(counts.begin(), counts.begin() + rank, 0);
  size_ = std::accumulate(counts.begin() + rank, counts.end(), first);
  number_.assign(halo.num_local(), 0);
  for (int k = 0; k < num_kept(); ++k) number_[kept_[k]] = first + k;
  halo.Fill(&number_);
}

template <class Visit>
void LocalElimination::ForEachInRow(const LocalRows& rows, int j, const Visit& visit) const {
  for (int k = rows.start[j]; k < rows.start[j + 1]; ++k) {
    const int other = rows.column[k];
    if (other >= rows.num_rows() || place_[other] >= 0) {
      visit(other, rows.value[k]);
      continue;
    }
    const Eliminated& e = eliminated_[~place_[other]];
    for (int m = 0; m < e.count; ++m) {
      visit(kept_[e.kept[m]], -(rows.value[k] * e.coupling[m]) * e.inverse);
    }
  }
}

bool LocalElimination::SetValues(const LocalRows& rows, const Halo& halo) {
  bool positive = true;
  for (Eliminated& e : eliminated_) {
    const double diagonal = rows.Diagonal(e.unknown);
    positive = positive && diagonal > 0;
    e.inverse = 1 / diagonal;
    std::copy_n(rows.value.begin() + rows.start[e.unknown] + 1, e.count, e.coupling.begin());
  }
  sign_.setOnes(halo.num_local());
  for (const int j : kept_) {
    const auto begin = rows.value.begin() + rows.start[j],
               end = rows.value.begin() + rows.start[j + 1];
    const bool few = end - begin <= kMaxNeighbours + 1;
    if (few && std::accumulate(begin + 1, end, 0.0) > 0) sign_[j] = -1;
  }
  halo.Fill(&sign_);
  return positive;
}

template <class Visit>
void LocalElimination::ForEachRow(const LocalRows& rows, const Visit& visit) const {
  std::vector<std::pair<int, double>> row;
  for (const int j : kept_) {
    row.clear();
    ForEachInRow(rows, j, [&](int i, double x) {
      const auto same = std::find_if(row.begin(), row.end(),
                                     [&](const auto& entry) { return entry.first == number_[i]; });
      const double signed_x = sign_[i] * sign_[j] * x;
      if (same == row.end()) {
        row.emplace_back(number_[i], signed_x);
      } else {
        same->second += signed_x;
      }
    });
    visit(row);
  }
}

/// Twice through the rows, which then take no more memory than they need.
MatrixRows LocalElimination::Complement(const LocalRows& rows) const {
  MatrixRows complement;
  complement.size = size_;
  complement.start.assign(1, 0);
  ForEachRow(rows, [&](const auto& row) {
    complement.start.push_back(complement.start.back() + static_cast<int>(row.size()));
  });
  complement.column.reserve(complement.start.back());
  complement.value.reserve(complement.start.back());
  ForEachRow(rows, [&](auto& row) {
    std::sort(row.begin(), row.end());
    for (const auto& [column, value] : row) {
      complement.column.push_back(column);
      complement.value.push_back(value);
    }
  });
  return complement;
}

Eigen::VectorXd LocalElimination::Reduce(const Eigen::VectorXd& b) const {
  Eigen::VectorXd reduced(num_kept());
  for (int k = 0; k < num_kept(); ++k) reduced[k] = b[kept_[k]];
  for (const Eliminated& e : eliminated_) {
    const double scaled = e.inverse * b[e.unknown];
    for (int m = 0; m < e.count; ++m) reduced[e.kept[m]] -= e.coupling[m] * scaled;
  }
  for (int k = 0; k < num_kept(); ++k) reduced[k] *= sign_[kept_[k]];
  return reduced;
}

void LocalElimination::Expand(const Eigen::VectorXd& of_kept, const Eigen::VectorXd& b,
                              Eigen::VectorXd* x) const {
  x->resize(b.size());
  for (int k = 0; k < num_kept(); ++k) (*x)[kept_[k]] = sign_[kept_[k]] * of_kept[k];
  for (const Eliminated& e : eliminated_) {
    double rest = b[e.unknown];
    for (int m = 0; m < e.count; ++m) rest -= e.coupling[m] * (*x)[kept_[e.kept[m]]];
    (*x)[e.unknown] = rest * e.inverse;
  }
}

}  // namespace cirque
