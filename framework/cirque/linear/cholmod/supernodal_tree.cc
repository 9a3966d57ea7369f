#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/supernodal_tree.h"

#include <algorithm>

#include "cirque/core/types.h"

namespace cirque {
namespace {

constexpr int kGroups = 16;
constexpr double kLargestSubtree = 0.03;  ///< of all work

}  // namespace

SupernodalTree::SupernodalTree(const cholmod_factor& factor)
    : factor_(factor),
      first_column_(static_cast<const int*>(factor.super)),
      first_row_(static_cast<const int*>(factor.pi)),
      rows_(static_cast<const int*>(factor.s)),
      supernode_(factor.n) {
  for (int s = 0; s < num_supernodes(); ++s) {
    std::fill_n(supernode_.begin() + FirstColumn(s), NumColumns(s), s);
    work_ += Work(s);
    most_rows_ = std::max(most_rows_, NumRows(s));
  }
  const std::vector<int> parent = FindParents();
  FindTopSupernodes(parent);
  DealOutSubtrees(parent);
  for (int s = 0; s < num_supernodes(); ++s) num_near_.push_back(CountNear(s));
}

std::vector<int> SupernodalTree::FindParents() const {
  std::vector<int> parent(num_supernodes(), kNone);
  for (int s = 0; s < num_supernodes(); ++s) {
    if (NumRows(s) > NumColumns(s)) parent[s] = supernode_[Rows(s)[NumColumns(s)]];
  }
  return parent;
}

void SupernodalTree::FindTopSupernodes(const std::vector<int>& parent) {
  std::vector<double> work_of_subtree(num_supernodes(), 0);
  is_top_.resize(num_supernodes());
  top_number_.assign(factor_.n, kNone);
  for (int s = 0; s < num_supernodes(); ++s) {
    work_of_subtree[s] += Work(s);
    if (parent[s] != kNone) work_of_subtree[parent[s]] += work_of_subtree[s];
    is_top_[s] = work_of_subtree[s] > kLargestSubtree * work_;
    if (!is_top_[s]) continue;
    top_.push_back(s);
    for (int j = FirstColumn(s); j < FirstColumn(s + 1); ++j) {
      top_number_[j] = static_cast<int>(top_columns_.size());
      top_columns_.push_back(j);
    }
  }
}

void SupernodalTree::DealOutSubtrees(const std::vector<int>& parent) {
  groups_.resize(kGroups);
  double done = 0;
  int group = 0, begin = 0;
  for (int s = 0; s < num_supernodes(); ++s) {
    done += Work(s);
    if (is_top_[s]) {
      begin = s + 1;
    } else if (parent[s] == kNone || is_top_[parent[s]]) {
      groups_[group].push_back({begin, s + 1});
      begin = s + 1;
      group = std::min(kGroups - 1, static_cast<int>(kGroups * done / work_));
    }
  }
}

int SupernodalTree::CountNear(int s) const {
  if (is_top_[s]) return NumRows(s);
  return static_cast<int>(std::partition_point(Rows(s), Rows(s) + NumRows(s),
                                               [&](int row) { return top_number_[row] == kNone; }) -
                          Rows(s));
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
