#include "cirque/layout/exact_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"
#include "cirque/intrinsic/overlay.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Vector = Eigen::Vector2d;
using Corner = Overlay::Corner;

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

/// How far crossings go towards even spacing, round after round.
constexpr double kSpread[] = {1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 1};

double Cross(const Vector& a, const Vector& b, const Vector& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

class ExactMapMaker {
 public:
  ExactMapMaker(const Triangulation& input, const Triangulation& other, const Cut& cut,
                const CornerUv& uv, Overlay overlay)
      : input_(input),
        other_(other),
        open_(CutOpen(other, cut)),
        uv_(uv),
        overlay_(std::move(overlay)),
        apex_(overlay_.num_faces(), 0) {
    std::vector<Index> on_input, on_other;
    for (const Crossing& crossing : overlay_.crossing) {
      on_input.push_back(input.edge[crossing.input]);
      on_other.push_back(other.edge[crossing.other]);
    }
    on_input_ = SortIntoBuckets(on_input, input.num_edges(), Order(&Crossing::along_input));
    on_other_ = SortIntoBuckets(on_other, other.num_edges(), Order(&Crossing::along_other));
  }

  Status Orient(ExactMapRepair* repair) {
    const std::vector<Crossing> before = overlay_.crossing;
    std::vector<bool> input_edge(input_.num_edges(), false), other_edge(other_.num_edges(), false);
    std::vector<Index> left = FindDegenerate(AllFaces());
    for (const double share : kSpread) {
      if (left.empty()) break;
      Mark(left, &input_edge, &other_edge);
      Spread(share, on_input_, input_edge, before, &Crossing::along_input);
      Spread(share, on_other_, other_edge, before, &Crossing::along_other);
      left = FindDegenerate(AllFaces());
    }
    repair->edges_spread = static_cast<int>(std::count(input_edge.begin(), input_edge.end(), true) +
                                            std::count(other_edge.begin(), other_edge.end(), true));
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Crossing &a = before[i], &b = overlay_.crossing[i];
      repair->largest_shift =
          std::max({repair->largest_shift, std::abs(a.along_input - b.along_input),
                    std::abs(a.along_other - b.along_other)});
    }
    if (left.empty()) return Status();
    return Status(StatusCode::kUnrepresentable,
                  fmt::format("the exact map has {} that doubles cannot hold, in face {} "
                              "(0-based) of the input the first",
                              Count(left.size(), "face"), overlay_.input_face[left.front()]));
  }

  ExactMap Make() const {
    ExactMap map;
    AddPoints(&map);
    std::vector<Index> order(overlay_.num_faces());
    std::iota(order.begin(), order.end(), 0);
    const Buckets by_input = SortIntoBuckets(overlay_.input_face, input_.num_faces(), order);
    std::vector<Index> uv_of(open_.num_vertices + 2 * overlay_.crossing.size(), kNone);
    for (const Index p : by_input.item) AddFace(p, &uv_of, &map);
    return map;
  }

 private:
  std::vector<Index> Order(double Crossing::*along) const {
    std::vector<Index> order(overlay_.crossing.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      return overlay_.crossing[a].*along < overlay_.crossing[b].*along;
    });
    return order;
  }

  std::vector<Index> AllFaces() const {
    std::vector<Index> faces(overlay_.num_faces());
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
  }

  std::span<const Corner> CornersOf(Index p) const {
    const Index first = overlay_.first_corner[p];
    return {&overlay_.corner[first],
            static_cast<std::size_t>(overlay_.first_corner[p + 1] - first)};
  }

  bool IsVertex(const Corner& corner) const { return corner.vertex < overlay_.num_vertices; }

  const Crossing& CrossingAt(const Corner& corner) const {
    return overlay_.crossing[corner.vertex - overlay_.num_vertices];
  }

  /// The same bits from both sides of an edge that is no seam.
  Vector UvAt(const Corner& corner) const {
    if (IsVertex(corner)) return uv_.value[corner.other];
    const Crossing& crossing = CrossingAt(corner);
    const bool along = corner.other == crossing.other;
    const Vector& tail = uv_.value[along ? Next(corner.other) : Prev(corner.other)];
    const Vector& tip = uv_.value[along ? Prev(corner.other) : Next(corner.other)];
    return tail + crossing.along_other * (tip - tail);
  }

  /// In the frame of its face of the input.
  SurfacePoint PointAt(const Corner& corner) const {
    SurfacePoint point{Triangulation::Face(corner.input), Eigen::Vector3d::Zero()};
    if (IsVertex(corner)) {
      point.barycentric[corner.input % 3] = 1;
      return point;
    }
    const Crossing& crossing = CrossingAt(corner);
    const bool along = corner.input == crossing.input;
    const Index tail = along ? Next(corner.input) : Prev(corner.input);
    const Index tip = along ? Prev(corner.input) : Next(corner.input);
    point.barycentric[tail % 3] = 1 - crossing.along_input;
    point.barycentric[tip % 3] = crossing.along_input;
    return point;
  }

  static bool ArePositive(std::span<const Vector> at, std::size_t apex) {
    const std::size_t n = at.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
      if (OrientationSign(at[apex], at[(apex + i) % n], at[(apex + i + 1) % n]) <= 0) return false;
    }
    return true;
  }

  static double LeastArea(std::span<const Vector> at, std::size_t apex) {
    const std::size_t n = at.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i + 1 < n; ++i) {
      least = std::min(least, Cross(at[apex], at[(apex + i) % n], at[(apex + i + 1) % n]));
    }
    return least;
  }

  /// Chooses the corner from which a face is cut into triangles; false where none will do.
  bool ChooseApex(Index p) {
    const std::span<const Corner> corners = CornersOf(p);
    std::array<Vector, 8> uv, on_input;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      uv[i] = UvAt(corners[i]);
      const Eigen::Vector3d& weight = PointAt(corners[i]).barycentric;
      on_input[i] = {weight[1], weight[2]};
    }
    const std::span<const Vector> in_plane{uv.data(), corners.size()};
    const std::span<const Vector> in_face{on_input.data(), corners.size()};
    double best = -std::numeric_limits<double>::infinity();
    bool found = false;
    for (std::size_t apex = 0; apex < (corners.size() == 3 ? 1 : corners.size()); ++apex) {
      const double least = LeastArea(in_plane, apex);
      if (least <= best || !ArePositive(in_plane, apex) || !ArePositive(in_face, apex)) continue;
      best = least;
      apex_[p] = static_cast<int>(apex);
      found = true;
    }
    return found;
  }

  std::vector<Index> FindDegenerate(const std::vector<Index>& faces) {
    std::vector<char> good(faces.size());
    ParallelFor(static_cast<Index>(faces.size()),
                [&](Index i) { good[i] = ChooseApex(faces[i]) ? 1 : 0; });
    std::vector<Index> degenerate;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (!good[i]) degenerate.push_back(faces[i]);
    }
    return degenerate;
  }

  /// The edges on which the faces have crossings.
  void Mark(const std::vector<Index>& faces, std::vector<bool>* input_edge,
            std::vector<bool>* other_edge) const {
    for (const Index p : faces) {
      for (const Corner& corner : CornersOf(p)) {
        if (IsVertex(corner)) continue;
        (*input_edge)[input_.edge[corner.input]] = true;
        (*other_edge)[other_.edge[corner.other]] = true;
      }
    }
  }

  void Spread(double share, const Buckets& on_edge, const std::vector<bool>& edge,
              const std::vector<Crossing>& before, double Crossing::*along) {
    for (std::size_t e = 0; e < edge.size(); ++e) {
      if (!edge[e]) continue;
      const Index first = on_edge.first[e], end = on_edge.first[e + 1];
      for (Index i = first; i < end; ++i) {
        const double even = static_cast<double>(i - first + 1) / (end - first + 1);
        const Index at = on_edge.item[i];
        overlay_.crossing[at].*along = before[at].*along + share * (even - before[at].*along);
      }
    }
  }

  void AddPoints(ExactMap* map) const {
    map->point.resize(overlay_.num_vertices + overlay_.crossing.size());
    for (Index h = input_.num_halfedges() - 1; h >= 0; --h) {
      SurfacePoint& point = map->point[input_.vertex[h]];
      point = {Triangulation::Face(h), Eigen::Vector3d::Unit(h % 3)};
    }
    for (std::size_t i = 0; i < overlay_.crossing.size(); ++i) {
      const Index vertex = overlay_.num_vertices + static_cast<Index>(i);
      map->point[vertex] = PointAt({vertex, overlay_.crossing[i].input, kNone});
    }
  }

  /// One number for what has one UV: of a crossing two where it lies on a seam.
  Index UvKey(const Corner& corner) const {
    if (IsVertex(corner)) return open_.vertex[corner.other];
    const Index crossing = corner.vertex - overlay_.num_vertices;
    const bool second =
        open_.twin[corner.other] == kNone && corner.other != CrossingAt(corner).other;
    return open_.num_vertices + 2 * crossing + (second ? 1 : 0);
  }

  void AddFace(Index p, std::vector<Index>* uv_of, ExactMap* map) const {
    const std::span<const Corner> corners = CornersOf(p);
    std::array<Index, 8> uv;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Index& number = (*uv_of)[UvKey(corners[i])];
      if (number == kNone) {
        number = static_cast<Index>(map->uv.size());
        map->uv.push_back(UvAt(corners[i]));
      }
      uv[i] = number;
    }
    const std::size_t n = corners.size(), apex = apex_[p];
    for (std::size_t i = 1; i + 1 < n; ++i) {
      for (const std::size_t k : {apex, (apex + i) % n, (apex + i + 1) % n}) {
        map->corner.push_back(corners[k].vertex);
        map->corner_uv.push_back(uv[k]);
      }
      map->face_of_input.push_back(overlay_.input_face[p]);
      map->face_of_solved.push_back(overlay_.other_face[p]);
    }
  }

  const Triangulation &input_, &other_;
  const Triangulation open_;
  const CornerUv& uv_;
  Overlay overlay_;
  std::vector<int> apex_;        // of every face: the corner from which it is cut into triangles
  Buckets on_input_, on_other_;  // the crossings of every edge in order
};

}  // namespace

Eigen::Vector3d InFace(const Triangulation& t, const SurfacePoint& point, Index face) {
  if (point.face == face) return point.barycentric;
  Eigen::Vector3d there = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    if (point.barycentric[k] == 0) continue;
    const Index v = t.vertex[3 * point.face + k];
    for (int j = 0; j < 3; ++j) {
      if (t.vertex[3 * face + j] == v) there[j] = point.barycentric[k];
    }
  }
  return there;
}

StatusOr<ExactMap> MakeExactMap(const Triangulation& input, const Triangulation& other,
                                const Cut& cut, const CornerUv& uv, Overlay overlay,
                                ExactMapRepair* repair) {
  ExactMapMaker maker(input, other, cut, uv, std::move(overlay));
  if (Status s = maker.Orient(repair); !s.ok()) return s;
  return maker.Make();
}

}  // namespace cirque
