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
#include "cirque/layout/exact_images.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Corner = Overlay::Corner;

/// How far crossings go towards even spacing, round after round.
constexpr double kSpread[] = {1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 1};

/// Weights of the last two corners of a face: coordinates in which it lies upright.
Eigen::Vector2d InFrame(const SurfacePoint& point) {
  return {point.barycentric[1], point.barycentric[2]};
}

/// `Image`: PlaneImage or SphereImage.
template <class Image>
class ExactMapMaker {
 public:
  ExactMapMaker(const Triangulation& input, const Triangulation& other, Image image,
                Overlay overlay)
      : input_(input),
        other_(other),
        image_(std::move(image)),
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
    NoteOtherFaces(left, &repair->too_small);
    return Status(StatusCode::kUnrepresentable,
                  fmt::format("the exact map has {} that doubles cannot hold, in face {} "
                              "(0-based) of the input the first",
                              Count(left.size(), "face"), overlay_.input_face[left.front()]));
  }

  /// The triangles; `place` notes where a corner is and returns its number among the places.
  template <class PlaceCorner>
  ExactMap Make(const PlaceCorner& place) const {
    ExactMap map;
    AddPoints(&map);
    const Buckets by_input = SortIntoBuckets(overlay_.input_face, input_.num_faces(), AllFaces());
    for (const Index p : by_input.item) AddFace(p, place, &map);
    return map;
  }

  bool IsVertex(const Corner& corner) const { return corner.vertex < overlay_.num_vertices; }

  const Crossing& CrossingAt(const Corner& corner) const {
    return overlay_.crossing[corner.vertex - overlay_.num_vertices];
  }

  typename Image::Point PlaceOf(const Corner& corner) const {
    return IsVertex(corner) ? typename Image::Point(image_.AtVertex(corner))
                            : image_.AtCrossing(corner, CrossingAt(corner));
  }

  const Image& image() const { return image_; }
  const Overlay& overlay() const { return overlay_; }

 private:
  using Point = typename Image::Point;

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

  /// In the frame of its face of the input.
  SurfacePoint PointAt(const Corner& corner) const {
    SurfacePoint point{Triangulation::Face(corner.input), Eigen::Vector3d::Zero()};
    if (IsVertex(corner)) {
      point.barycentric[corner.input % 3] = 1;
      return point;
    }
    const Crossing& crossing = CrossingAt(corner);
    const SideOfCrossing side(corner.input, crossing.input);
    point.barycentric[side.tail % 3] = 1 - crossing.along_input;
    point.barycentric[side.tip % 3] = crossing.along_input;
    return point;
  }

  /// Whether the test holds for every triangle of a polygon cut from the corner `apex`.
  template <class Each>
  static bool AllOf(std::size_t n, std::size_t apex, const Each& test) {
    for (std::size_t i = 1; i + 1 < n; ++i) {
      if (!test(apex, (apex + i) % n, (apex + i + 1) % n)) return false;
    }
    return true;
  }

  /// Chooses the corner from which a face is cut into triangles; false where none will do.
  bool ChooseApex(Index p) {
    const std::span<const Corner> corners = CornersOf(p);
    std::array<Point, 8> at;
    std::array<Eigen::Vector2d, 8> on_input;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      at[i] = PlaceOf(corners[i]);
      on_input[i] = InFrame(PointAt(corners[i]));
    }
    double best = -std::numeric_limits<double>::infinity();
    bool found = false;
    for (std::size_t apex = 0; apex < (corners.size() == 3 ? 1 : corners.size()); ++apex) {
      double least = std::numeric_limits<double>::infinity();
      const bool positive =
          AllOf(corners.size(), apex, [&](std::size_t a, std::size_t b, std::size_t c) {
            least = std::min(least, Image::Size(at[a], at[b], at[c]));
            return least > best && Image::IsPositive(at[a], at[b], at[c]) &&
                   OrientationSign(on_input[a], on_input[b], on_input[c]) > 0;
          });
      if (!positive) continue;
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

  void NoteOtherFaces(const std::vector<Index>& faces, std::vector<Index>* other) const {
    for (const Index p : faces) other->push_back(overlay_.other_face[p]);
    std::sort(other->begin(), other->end());
    other->erase(std::unique(other->begin(), other->end()), other->end());
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

  template <class PlaceCorner>
  void AddFace(Index p, const PlaceCorner& place, ExactMap* map) const {
    const std::span<const Corner> corners = CornersOf(p);
    const std::size_t n = corners.size(), apex = apex_[p];
    std::array<Index, 8> number;
    for (std::size_t i = 0; i < n; ++i) number[i] = place(corners[i], map);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      for (const std::size_t k : {apex, (apex + i) % n, (apex + i + 1) % n}) {
        map->corner.push_back(corners[k].vertex);
        map->corner_uv.push_back(number[k]);
      }
      map->face_of_input.push_back(overlay_.input_face[p]);
      map->face_of_solved.push_back(overlay_.other_face[p]);
    }
  }

  const Triangulation &input_, &other_;
  const Image image_;
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
                                ExactMapRepair* repair, std::optional<int> grid) {
  ExactMapMaker maker(input, other, PlaneImage(other, cut, uv, grid), std::move(overlay));
  if (Status s = maker.Orient(repair); !s.ok()) return s;
  const PlaneImage& image = maker.image();
  std::vector<Index> uv_of(image.NumKeys(maker.overlay().crossing.size()), kNone);
  return maker.Make([&](const Corner& corner, ExactMap* map) {
    const Index crossing = corner.vertex - maker.overlay().num_vertices;
    Index& number = uv_of[maker.IsVertex(corner)
                              ? image.KeyOfVertex(corner)
                              : image.KeyOfCrossing(corner, maker.CrossingAt(corner), crossing)];
    if (number == kNone) {
      number = static_cast<Index>(map->uv.size());
      map->uv.push_back(maker.PlaceOf(corner));
    }
    return number;
  });
}

StatusOr<ExactMap> MakeExactSphereMap(const Triangulation& input, const Triangulation& other,
                                      const std::vector<Eigen::Vector3d>& position, Overlay overlay,
                                      ExactMapRepair* repair) {
  ExactMapMaker maker(input, other, SphereImage(other, position), std::move(overlay));
  if (Status s = maker.Orient(repair); !s.ok()) return s;
  ExactMap made = maker.Make([&](const Corner& corner, ExactMap* map) {
    map->position.resize(map->point.size());
    map->position[corner.vertex] = maker.PlaceOf(corner);
    return corner.vertex;
  });
  made.corner_uv.clear();
  return made;
}

}  // namespace cirque
