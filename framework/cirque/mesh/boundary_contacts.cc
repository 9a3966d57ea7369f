#include "cirque/mesh/boundary_contacts.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/io/polygon_soup.h"

namespace cirque {
namespace {

/// Edges in a tree of boxes, halved along the longest side.
class EdgeTree {
 public:
  EdgeTree(const std::vector<Eigen::Vector3d>& points, const BoundaryEdges& edges)
      : points_(points), edges_(edges), order_(edges.size()), boxes_(2 * edges.size() + 2) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!edges.empty()) Build(0, static_cast<Index>(edges.size()), 0);
  }

  /// Whether `visit(edge)` is true for some edge whose box holds the point, but for rounding.
  template <class Visit>
  bool AnyAt(const Eigen::Vector3d& p, const Visit& visit) const {
    return !edges_.empty() && AnyAt(p, visit, 0, static_cast<Index>(edges_.size()), 0);
  }

 private:
  /// The node of [begin, end); its children follow it: the first next, the second behind that one's
  /// 2 n - 1 nodes.
  static Index SecondChild(Index node, Index half) { return node + 2 * half; }

  void Build(Index begin, Index end, Index node) {
    Eigen::AlignedBox3d box;
    for (Index i = begin; i < end; ++i) {
      box.extend(points_[edges_[order_[i]].first]);
      box.extend(points_[edges_[order_[i]].second]);
    }
    boxes_[node] = box;
    if (end - begin == 1) return;
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto middle = [&](Index e) {
      return points_[edges_[e].first][axis] + points_[edges_[e].second][axis];
    };
    const Index half = (end - begin) / 2;
    std::nth_element(
        order_.begin() + begin, order_.begin() + begin + half, order_.begin() + end,
        [&](Index e, Index f) { return std::pair(middle(e), e) < std::pair(middle(f), f); });
    Build(begin, begin + half, node + 1);
    Build(begin + half, end, SecondChild(node, half));
  }

  template <class Visit>
  bool AnyAt(const Eigen::Vector3d& p, const Visit& visit, Index begin, Index end,
             Index node) const {
    const Eigen::AlignedBox3d& box = boxes_[node];
    const double slack = 1e-9 * box.sizes().maxCoeff();
    if ((p - box.max()).maxCoeff() > slack || (box.min() - p).maxCoeff() > slack) return false;
    if (end - begin == 1) return visit(edges_[order_[begin]]);
    const Index half = (end - begin) / 2;
    return AnyAt(p, visit, begin, begin + half, node + 1) ||
           AnyAt(p, visit, begin + half, end, SecondChild(node, half));
  }

  const std::vector<Eigen::Vector3d>& points_;
  const BoundaryEdges& edges_;
  std::vector<Index> order_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

bool LiesInside(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double length = (b - a).norm(), near = 1e-9 * length;
  if (!((p - a).norm() > near) || !((p - b).norm() > near)) return false;
  const double along = (p - a).dot(b - a) / length;
  return along > 0 && along < length && ((p - a) - along / length * (b - a)).norm() <= near;
}

}  // namespace

std::vector<Index> FindTJunctions(const std::vector<Eigen::Vector3d>& points,
                                  const BoundaryEdges& edges) {
  std::vector<Index> ends;
  for (const auto& [a, b] : edges) ends.insert(ends.end(), {a, b});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const EdgeTree tree(points, edges);
  std::erase_if(ends, [&](Index v) {
    return !tree.AnyAt(points[v], [&](const std::pair<Index, Index>& edge) {
      return LiesInside(points[v], points[edge.first], points[edge.second]);
    });
  });
  return ends;
}

Index CountCoincidentEdges(const std::vector<Eigen::Vector3d>& points, const BoundaryEdges& edges) {
  const std::vector<Index> first = FirstOfEqualPoints(points);
  BoundaryEdges sorted;
  for (const auto& [a, b] : edges) sorted.emplace_back(std::minmax({first[a], first[b]}));
  std::sort(sorted.begin(), sorted.end());
  Index count = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool as_before = i > 0 && sorted[i - 1] == sorted[i];
    const bool as_next = i + 1 < sorted.size() && sorted[i + 1] == sorted[i];
    if (as_before || as_next) ++count;
  }
  return count;
}

}  // namespace cirque
