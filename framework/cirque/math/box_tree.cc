#include "cirque/math/box_tree.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "cirque/core/sort_keys.h"

namespace cirque {
namespace {

constexpr Index kLeafSize = 8;  ///< boxes

/// Of points in a box: how far along the curve each comes, in bits of all coordinates in turn.
template <int N>
class MortonCurve {
 public:
  using Point = Eigen::Matrix<double, N, 1>;

  explicit MortonCurve(const Eigen::AlignedBox<double, N>& points) : origin_(points.min()) {
    const double size = points.sizes().maxCoeff();
    if (size > 0) scale_ = (kCells - 1) / size;
  }

  /// A whole number between 2^52 and 2^53: all of them have one exponent, so SortKeys deals them evenly.
  double At(const Point& point) const {
    const Point cell = scale_ * (point - origin_);
    std::uint64_t key = 1;
    for (int bit = kBits; bit-- > 0;) {
      for (int k = 0; k < N; ++k)
        key = 2 * key + ((static_cast<std::uint64_t>(cell[k]) >> bit) & 1);
    }
    return static_cast<double>(key << (52 - N * kBits));
  }

 private:
  static constexpr int kBits = 52 / N;
  static constexpr double kCells = static_cast<double>(std::uint64_t{1} << kBits);

  Point origin_;
  double scale_ = 0;
};

/// The boxes in the order of their centres along the curve.
template <int N>
std::vector<Index> AlongCurve(const std::vector<Eigen::AlignedBox<double, N>>& boxes) {
  Eigen::AlignedBox<double, N> centres;
  for (const auto& box : boxes) centres.extend(box.center());
  const MortonCurve<N> curve(centres);
  std::vector<std::pair<double, int>> keys(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    keys[i] = {curve.At(boxes[i].center()), static_cast<Index>(i)};
  }
  SortKeys(&keys);
  std::vector<Index> order(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) order[i] = keys[i].second;
  return order;
}

}  // namespace

template <int N>
BoxTreeOf<N>::BoxTreeOf(std::vector<Box> boxes)
    : boxes_(std::move(boxes)), order_(AlongCurve<N>(boxes_)) {
  if (!order_.empty()) Build(0, static_cast<Index>(order_.size()));
}

template <int N>
Index BoxTreeOf<N>::Build(Index begin, Index end) {
  const auto id = static_cast<Index>(nodes_.size());
  nodes_.push_back({.begin = begin, .end = end});
  if (end - begin <= kLeafSize) {
    for (Index k = begin; k < end; ++k) nodes_[id].box.extend(boxes_[order_[k]]);
    return id;
  }
  const Index middle = begin + (end - begin) / 2;
  const Index left = Build(begin, middle), right = Build(middle, end);
  nodes_[id].left = left;
  nodes_[id].right = right;
  nodes_[id].box = nodes_[left].box.merged(nodes_[right].box);
  return id;
}

template class BoxTreeOf<2>;
template class BoxTreeOf<3>;

}  // namespace cirque
