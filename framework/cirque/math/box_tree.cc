#include "cirque/math/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cirque {
namespace {

constexpr Index kLeafSize = 8;  ///< boxes

}  // namespace

template <int N>
BoxTreeOf<N>::BoxTreeOf(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes_.empty()) Build(0, static_cast<Index>(boxes_.size()));
}

template <int N>
Index BoxTreeOf<N>::Build(Index begin, Index end) {
  const auto id = static_cast<Index>(nodes_.size());
  Node node{.begin = begin, .end = end};
  for (Index k = begin; k < end; ++k) node.box.extend(boxes_[order_[k]]);
  nodes_.push_back(node);
  if (end - begin <= kLeafSize) return id;
  Eigen::Index axis = 0;
  node.box.sizes().maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index i, Index j) {
                     return boxes_[i].min()[axis] + boxes_[i].max()[axis] <
                            boxes_[j].min()[axis] + boxes_[j].max()[axis];
                   });
  const Index left = Build(begin, middle), right = Build(middle, end);
  nodes_[id].left = left;
  nodes_[id].right = right;
  return id;
}

template class BoxTreeOf<2>;
template class BoxTreeOf<3>;

}  // namespace cirque
