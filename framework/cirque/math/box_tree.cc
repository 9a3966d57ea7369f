#include "cirque/math/box_tree.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cirque {
namespace {

constexpr Index kLeafSize = 8;  ///< boxes

}  // namespace

template <int N>
BoxTreeOf<N>::BoxTreeOf(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  std::vector<Item> items(boxes_.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Eigen::Matrix<double, N, 1> centre = boxes_[i].min() + boxes_[i].max();
    std::copy(centre.begin(), centre.end(), items[i].centre.begin());
    items[i].box = static_cast<Index>(i);
  }
  if (!items.empty()) Build(0, static_cast<Index>(items.size()), &items);
  order_.reserve(items.size());
  for (const Item& item : items) order_.push_back(item.box);
}

template <int N>
Index BoxTreeOf<N>::Build(Index begin, Index end, std::vector<Item>* items) {
  const auto id = static_cast<Index>(nodes_.size());
  nodes_.push_back({.begin = begin, .end = end});
  if (end - begin <= kLeafSize) {
    for (Index k = begin; k < end; ++k) nodes_[id].box.extend(boxes_[(*items)[k].box]);
    return id;
  }
  Box centres;
  for (Index k = begin; k < end; ++k) {
    centres.extend(Eigen::Map<const Eigen::Matrix<double, N, 1>>((*items)[k].centre.data()));
  }
  Eigen::Index axis = 0;
  centres.sizes().maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(
      items->begin() + begin, items->begin() + middle, items->begin() + end,
      [axis](const Item& a, const Item& b) { return a.centre[axis] < b.centre[axis]; });
  const Index left = Build(begin, middle, items), right = Build(middle, end, items);
  nodes_[id].left = left;
  nodes_[id].right = right;
  nodes_[id].box = nodes_[left].box.merged(nodes_[right].box);
  return id;
}

template class BoxTreeOf<2>;
template class BoxTreeOf<3>;

}  // namespace cirque
