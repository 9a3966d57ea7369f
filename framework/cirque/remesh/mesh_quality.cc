#include "cirque/remesh/mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace cirque {
namespace {

using Point = Eigen::Vector3d;
using Triangles = std::vector<Point>;  ///< three corners each

constexpr Index kLeaf = 4;

Triangles CornersOf(const Triangulation& t, const std::vector<Point>& position) {
  Triangles corners;
  for (const Index v : t.vertex) corners.push_back(position[v]);
  return corners;
}

/// The nearest point of a segment.
Point OnSegment(const Point& a, const Point& b, const Point& p) {
  const Point along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0., 1.) : 0;
  return a + t * along;
}

/// The largest distance of vertices, midpoints of edges and centroids from a tree's triangles.
double LargestDistance(const Triangles& from, const TriangleTree& tree) {
  double largest = 0;
  for (std::size_t i = 0; i + 2 < from.size(); i += 3) {
    const Point &a = from[i], &b = from[i + 1], &c = from[i + 2];
    for (const Point& p :
         {a, Point((a + b) / 2), Point((b + c) / 2), Point((c + a) / 2), Point((a + b + c) / 3)}) {
      largest = std::max(largest, tree.Distance(p));
    }
  }
  return largest;
}

void MeasureAngles(const Triangulation& t, const std::vector<Point>& position,
                   MeshQuality* quality) {
  quality->least_angle = 180;
  for (Index f = 0; f < t.num_faces(); ++f) {
    double least = kPi;
    for (Index c = 3 * f; c < 3 * f + 3; ++c) {
      const Point a = position[t.Tail(c)] - position[t.vertex[c]];
      const Point b = position[t.Tip(c)] - position[t.vertex[c]];
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      least = std::min(least, angle);
      quality->largest_angle = std::max(quality->largest_angle, angle * 180 / kPi);
    }
    quality->least_angle = std::min(quality->least_angle, least * 180 / kPi);
    quality->mean_least_angle += least * 180 / kPi / t.num_faces();
  }
}

void MeasureEdges(const Triangulation& t, const std::vector<Point>& position,
                  MeshQuality* quality) {
  Eigen::VectorXd length(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    length[e] = (position[t.Tip(h)] - position[t.Tail(h)]).norm();
  }
  quality->mean_edge = length.mean();
  quality->edge_deviation =
      std::sqrt((length.array() - length.mean()).square().mean()) / length.mean();
  quality->edge_ratio = length.maxCoeff() / length.minCoeff();
}

}  // namespace

MeshQuality MeasureQuality(const Triangulation& t, const std::vector<Point>& position) {
  MeshQuality quality;
  quality.vertices = t.num_vertices;
  quality.triangles = t.num_faces();
  MeasureAngles(t, position, &quality);
  MeasureEdges(t, position, &quality);
  const std::vector<bool> on_boundary = BoundaryVertices(t);
  const std::vector<Index> corners = CornersPerVertex(t);
  Index inner = 0, regular = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (on_boundary[v]) continue;
    ++inner;
    regular += corners[v] == 6 ? 1 : 0;
  }
  quality.regular = inner > 0 ? static_cast<double>(regular) / inner : 1;
  return quality;
}

void MeasureDistances(const Triangulation& t, const std::vector<Point>& position,
                      const Surface& other, MeshQuality* quality) {
  const Triangles own = CornersOf(t, position);
  const Triangles others = CornersOf(other.triangulation, other.position);
  Eigen::AlignedBox3d box;
  for (const Point& p : others) box.extend(p);
  const double size = box.diagonal().norm();
  quality->to_other = LargestDistance(own, TriangleTree(others)) / size;
  quality->from_other = LargestDistance(others, TriangleTree(own)) / size;
}

namespace {

std::vector<std::pair<const char*, double>> Values(const MeshQuality& quality) {
  return {{"vertices", quality.vertices},
          {"triangles", quality.triangles},
          {"least_angle", quality.least_angle},
          {"mean_least_angle", quality.mean_least_angle},
          {"largest_angle", quality.largest_angle},
          {"mean_edge", quality.mean_edge},
          {"edge_deviation", quality.edge_deviation},
          {"edge_ratio", quality.edge_ratio},
          {"regular", quality.regular},
          {"to_other", quality.to_other},
          {"from_other", quality.from_other}};
}

}  // namespace

std::string ToText(const MeshQuality& quality) {
  std::string text;
  for (const auto& [name, value] : Values(quality)) {
    text += fmt::format("{:<17} {:.6g}\n", name, value);
  }
  return text;
}

std::string ToJson(const MeshQuality& quality) {
  std::string text = "{";
  for (const auto& [name, value] : Values(quality)) {
    text += fmt::format("{}\n  \"{}\": {}", text == "{" ? "" : ",", name, value);
  }
  return text + "\n}\n";
}

TriangleTree::TriangleTree(std::vector<Point> corners) : corner_(std::move(corners)) {
  order_.resize(corner_.size() / 3);
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty()) Build(0, static_cast<Index>(order_.size()));
}

Index TriangleTree::Build(Index begin, Index end) {
  const auto index = static_cast<Index>(node_.size());
  Eigen::AlignedBox3d box;
  for (Index i = begin; i < end; ++i) {
    for (Index k = 0; k < 3; ++k) box.extend(corner_[3 * order_[i] + k]);
  }
  node_.push_back({box.min(), box.max(), begin, end, kNone});
  if (end - begin <= kLeaf) return index;
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  const auto at = [this, axis](Index t) {
    return corner_[3 * t][axis] + corner_[3 * t + 1][axis] + corner_[3 * t + 2][axis];
  };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&at](Index a, Index b) { return at(a) < at(b); });
  Build(begin, middle);
  const Index right = Build(middle, end);
  node_[index].right = right;
  return index;
}

double TriangleTree::SquaredDistanceToBox(Index node, const Point& point) const {
  const Point inside = point.cwiseMax(node_[node].lower).cwiseMin(node_[node].upper);
  return (point - inside).squaredNorm();
}

double TriangleTree::SquaredDistanceToTriangle(Index triangle, const Point& point) const {
  const Point &a = corner_[3 * triangle], &b = corner_[3 * triangle + 1],
              &c = corner_[3 * triangle + 2];
  const Point normal = (b - a).cross(c - a);
  const bool is_above = normal.dot((b - a).cross(point - a)) >= 0 &&
                        normal.dot((c - b).cross(point - b)) >= 0 &&
                        normal.dot((a - c).cross(point - c)) >= 0;
  if (is_above && normal.squaredNorm() > 0) {
    const double height = normal.normalized().dot(point - a);
    return height * height;
  }
  return std::min({(point - OnSegment(a, b, point)).squaredNorm(),
                   (point - OnSegment(b, c, point)).squaredNorm(),
                   (point - OnSegment(c, a, point)).squaredNorm()});
}

double TriangleTree::Distance(const Point& point) const {
  double least = std::numeric_limits<double>::infinity();
  std::vector<Index> stack;
  if (!node_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const Index index = stack.back();
    stack.pop_back();
    if (SquaredDistanceToBox(index, point) >= least) continue;
    const Node& node = node_[index];
    if (node.right == kNone) {
      for (Index i = node.begin; i < node.end; ++i)
        least = std::min(least, SquaredDistanceToTriangle(order_[i], point));
      continue;
    }
    Index near = index + 1, far = node.right;
    if (SquaredDistanceToBox(far, point) < SquaredDistanceToBox(near, point)) std::swap(near, far);
    stack.push_back(far);
    stack.push_back(near);
  }
  return std::sqrt(least);
}

}  // namespace cirque
