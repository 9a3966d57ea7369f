#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "cirque/core/grouping.h"
#include "cirque/core/triangulation.h"
#include "cirque/mesh/assembly.h"
#include "cirque/mesh/ear_cutting.h"

namespace cirque {
namespace {

/// How many triangles vertices are to have.
struct Wish {
  int inner, boundary;
  double kept_angle;  ///< the share of the least angle there that must be left

  int At(bool inside) const { return inside ? inner : boundary; }
};

constexpr Wish kWishes[] = {{3, 1, 0}, {4, 2, 0.5}};

/// A diagonal between two triangles of a polygon, as the halfedge of the one that is opposite the
/// vertex that gains by the flip, and what the two triangles behind it would be like.
struct Flip {
  Index halfedge = kNone;
  double sharpness = 1;
};

class ValenceRaiser {
 public:
  ValenceRaiser(const PolygonSoup& soup, TriangleSoup* triangles)
      : soup_(soup),
        t_(*triangles),
        num_vertices_(static_cast<Index>(soup.position.size())),
        valence_(num_vertices_, 0) {
    for (const Index v : t_.vertex) ++valence_[v];
  }

  void Run() {
    std::vector<Index> poor = PoorVertices();
    if (poor.empty()) return;
    corners_ = SortIntoBuckets(soup_.corner, num_vertices_);
    first_triangle_.assign(soup_.num_polygons() + 1, 0);
    for (const Index p : t_.polygon) ++first_triangle_[p + 1];
    for (std::size_t p = 1; p < first_triangle_.size(); ++p) {
      first_triangle_[p] += first_triangle_[p - 1];
    }
    std::sort(poor.begin(), poor.end(), [&](Index v, Index w) {
      if (valence_[v] != valence_[w]) return valence_[v] < valence_[w];
      return ComesBefore(soup_.position[v], soup_.position[w]);
    });
    for (const Wish& wish : kWishes) {
      for (const Index v : poor) Raise(v, wish);
    }
  }

 private:
  /// Those with a diagonal opposite of them.
  std::vector<Index> PoorVertices() const {
    std::vector<Index> poor;
    for (Index h = 0; h < static_cast<Index>(t_.mate.size()); ++h) {
      const bool is_poor = valence_[t_.vertex[h]] < kWishes[1].inner;
      if (t_.mate[h] != kNone && is_poor) poor.push_back(t_.vertex[h]);
    }
    std::sort(poor.begin(), poor.end());
    poor.erase(std::unique(poor.begin(), poor.end()), poor.end());
    return poor;
  }

  /// Whether two polygons meet at every side that ends at the vertex.
  bool IsInside(Index v) const {
    std::vector<Index> ends;
    for (Index i = corners_.first[v]; i < corners_.first[v + 1]; ++i) {
      const Index c = corners_.item[i], p = PolygonOf(c);
      if (first_triangle_[p] == first_triangle_[p + 1]) continue;
      const Index begin = soup_.first_corner[p], end = soup_.first_corner[p + 1];
      ends.push_back(soup_.corner[c + 1 < end ? c + 1 : begin]);
      ends.push_back(soup_.corner[c > begin ? c - 1 : end - 1]);
    }
    std::sort(ends.begin(), ends.end());
    if (ends.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      if (ends[i] != ends[i + 1]) return false;
    }
    return true;
  }

  Index PolygonOf(Index corner) const {
    const auto after =
        std::upper_bound(soup_.first_corner.begin(), soup_.first_corner.end(), corner);
    return static_cast<Index>(after - soup_.first_corner.begin()) - 1;
  }

  void Raise(Index v, const Wish& wish) {
    const int least = wish.At(IsInside(v));
    while (valence_[v] < least) {
      const Flip flip = BestFlip(v, wish);
      if (flip.halfedge == kNone) return;
      Apply(flip.halfedge);
    }
  }

  Flip BestFlip(Index v, const Wish& wish) const {
    Flip best;
    for (Index i = corners_.first[v]; i < corners_.first[v + 1]; ++i) {
      const Index p = PolygonOf(corners_.item[i]);
      for (Index h = 3 * first_triangle_[p]; h < 3 * first_triangle_[p + 1]; ++h) {
        if (t_.corner[h] != corners_.item[i] || t_.mate[h] == kNone) continue;
        const std::optional<double> sharpness = Judge(h, wish);
        if (!sharpness || *sharpness > best.sharpness) continue;
        const bool better =
            best.halfedge == kNone || *sharpness < best.sharpness ||
            ComesBefore(soup_.position[Across(h)], soup_.position[Across(best.halfedge)]);
        if (better) best = {h, *sharpness};
      }
    }
    return best;
  }

  Index Across(Index h) const { return t_.vertex[t_.mate[h]]; }

  /// The sharpness of the triangles behind the flip; nothing where it may not be done.
  std::optional<double> Judge(Index h, const Wish& wish) const {
    const Index g = t_.mate[h];
    const Index c = t_.vertex[h], d = t_.vertex[g];
    const Index n = t_.vertex[Triangulation::Next(h)], p = t_.vertex[Triangulation::Prev(h)];
    for (const Index loser : {n, p}) {
      if (valence_[loser] <= wish.At(IsInside(loser))) return std::nullopt;
    }
    if (c == d || n == p) return std::nullopt;
    const Eigen::Vector3d &x = soup_.position[c], &y = soup_.position[n], &z = soup_.position[d],
                          &w = soup_.position[p];
    if (IsZeroArea(x, y, z) || IsZeroArea(x, z, w)) return std::nullopt;
    // The two new triangles face one way with the two old ones together.
    const Eigen::Vector3d normal = (z - x).cross(w - y);
    if (!(normal.dot((y - x).cross(z - x)) > 0) || !(normal.dot((z - x).cross(w - x)) > 0)) {
      return std::nullopt;
    }
    const double before = std::max(Sharpness(x, y, w), Sharpness(y, z, w));
    const double after = std::max(Sharpness(x, y, z), Sharpness(x, z, w));
    const bool too_sharp = std::acos(after) < wish.kept_angle * std::acos(before);
    return too_sharp ? std::nullopt : std::optional(after);
  }

  /// Triangles (c, n, p) and (d, p, n) become (c, n, d) and (c, d, p).
  void Apply(Index h) {
    const Index g = t_.mate[h];
    const std::array<Index, 3> c = {h, Triangulation::Next(h), Triangulation::Prev(h)};
    const std::array<Index, 3> d = {g, Triangulation::Next(g), Triangulation::Prev(g)};
    const std::array<Index, 4> corner = {t_.corner[c[0]], t_.corner[c[1]], t_.corner[d[0]],
                                         t_.corner[c[2]]};
    // Across the sides from c to n, n to d, d to p and p to c.
    const std::array<Index, 4> outside = {t_.mate[c[2]], t_.mate[d[1]], t_.mate[d[2]],
                                          t_.mate[c[1]]};
    const Index a = 3 * Triangulation::Face(h), b = 3 * Triangulation::Face(g);
    SetTriangle(a, {corner[0], corner[1], corner[2]}, {outside[1], b + 2, outside[0]});
    SetTriangle(b, {corner[0], corner[2], corner[3]}, {outside[2], outside[3], a + 1});
    ++valence_[soup_.corner[corner[0]]];
    --valence_[soup_.corner[corner[1]]];
    ++valence_[soup_.corner[corner[2]]];
    --valence_[soup_.corner[corner[3]]];
  }

  void SetTriangle(Index first, const std::array<Index, 3>& corner,
                   const std::array<Index, 3>& mate) {
    for (Index k = 0; k < 3; ++k) {
      t_.corner[first + k] = corner[k];
      t_.vertex[first + k] = soup_.corner[corner[k]];
      t_.mate[first + k] = mate[k];
      if (mate[k] != kNone) t_.mate[mate[k]] = first + k;
    }
  }

  const PolygonSoup& soup_;
  TriangleSoup& t_;
  const Index num_vertices_;
  std::vector<int> valence_;
  Buckets corners_;  ///< of the soup, by vertex
  std::vector<Index> first_triangle_;
};

}  // namespace

void RaiseValences(const PolygonSoup& soup, TriangleSoup* triangles) {
  const auto num_triangles = static_cast<Index>(triangles->polygon.size());
  if (num_triangles > soup.num_polygons()) ValenceRaiser(soup, triangles).Run();
}

}  // namespace cirque
