#include "cirque/generators/planar_delaunay.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// A growing triangulation of the sphere that one gets by adding a ghost point at infinity: the
/// ghost triangle (b, a, ghost) lies outside the hull's edge from a to b.
class Insertion {
 public:
  explicit Insertion(const Points& points)
      : points_(points),
        ghost_(static_cast<Index>(points.size())),
        face_from_(points.size() + 1, kNone) {
    faces_.reserve(2 * points.size() + 2);
  }

  /// Begins with a counter-clockwise triangle and its three ghosts.
  void Start(Index a, Index b, Index c) {
    faces_ = {{{a, b, c}, {2, 3, 1}, kNone},
              {{b, a, ghost_}, {3, 2, 0}, kNone},
              {{c, b, ghost_}, {1, 3, 0}, kNone},
              {{a, c, ghost_}, {2, 1, 0}, kNone}};
  }

  /// Adds a point; returns the point it coincides with, else kNone.
  Index Insert(Index p) {
    const Index start = Locate(p);
    for (const Index v : faces_[start].corner) {
      if (v != ghost_ && points_[v] == points_[p]) return v;
    }
    FindCavity(start, p);
    FillCavity(p);
    return kNone;
  }

  /// All triangles, the ghost as kNone.
  std::vector<Triangle> Triangles() const {
    std::vector<Triangle> triangles;
    triangles.reserve(faces_.size());
    for (const Face& face : faces_) {
      Triangle& triangle = triangles.emplace_back(face.corner);
      std::replace(triangle.begin(), triangle.end(), ghost_, kNone);
    }
    return triangles;
  }

 private:
  struct Face {
    Triangle corner;
    std::array<Index, 3> neighbor;  ///< opposite the corner of the same slot
    Index taken_by;                 ///< the point whose cavity took this face last
  };

  /// An edge of the cavity's rim, the cavity on its left, and the face beyond.
  struct RimEdge {
    Index tail, tip, beyond;
  };

  int GhostCorner(Index f) const {
    for (int k = 0; k < 3; ++k) {
      if (faces_[f].corner[k] == ghost_) return k;
    }
    return kNone;
  }

  int Side(Index f, int k, Index p) const {
    const Triangle& corner = faces_[f].corner;
    return OrientationSign(points_[corner[(k + 1) % 3]], points_[corner[(k + 2) % 3]], points_[p]);
  }

  /// Walks towards p, through edges that have p on their far side; in a Delaunay triangulation such
  /// a walk never returns. Ends in the triangle that contains p or in a ghost that sees it.
  Index Locate(Index p) const {
    Index f = latest_;
    for (bool moved = true; moved && GhostCorner(f) == kNone;) {
      moved = false;
      for (int k = 0; k < 3 && !moved; ++k) {
        if (Side(f, k, p) >= 0) continue;
        f = faces_[f].neighbor[k];
        moved = true;
      }
    }
    return f;
  }

  /// Whether p lies strictly inside the circumcircle; a ghost's is the open half-plane beyond its
  /// hull edge with the edge's open segment.
  bool InConflict(Index f, Index p) const {
    const Triangle& v = faces_[f].corner;
    const int k = GhostCorner(f);
    if (k == kNone) {
      return InCircleSign(points_[v[0]], points_[v[1]], points_[v[2]], points_[p]) > 0;
    }
    const int side = Side(f, k, p);
    return side > 0 ||
           (side == 0 && Between(points_[v[(k + 1) % 3]], points_[v[(k + 2) % 3]], points_[p]));
  }

  /// Whether p, on the line through a and b, lies strictly between them.
  static bool Between(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                      const Eigen::Vector2d& p) {
    const int axis = a.x() != b.x() ? 0 : 1;
    return std::min(a[axis], b[axis]) < p[axis] && p[axis] < std::max(a[axis], b[axis]);
  }

  /// Collects the faces in conflict with p, a connected set that p sees whole, and its rim.
  void FindCavity(Index start, Index p) {
    cavity_.assign(1, start);
    rim_.clear();
    faces_[start].taken_by = p;
    for (std::size_t i = 0; i < cavity_.size(); ++i) {
      const Face& face = faces_[cavity_[i]];
      for (int k = 0; k < 3; ++k) {
        const Index g = face.neighbor[k];
        if (faces_[g].taken_by == p) continue;
        if (InConflict(g, p)) {
          faces_[g].taken_by = p;
          cavity_.push_back(g);
        } else {
          rim_.push_back({face.corner[(k + 1) % 3], face.corner[(k + 2) % 3], g});
        }
      }
    }
  }

  /// Replaces the cavity by the star of p. The star has two faces more than the cavity had.
  void FillCavity(Index p) {
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      const auto [tail, tip, beyond] = rim_[i];
      const bool reuse = i < cavity_.size();
      const Index f = reuse ? cavity_[i] : static_cast<Index>(faces_.size());
      if (!reuse) faces_.emplace_back();
      faces_[f] = {{tail, tip, p}, {kNone, kNone, beyond}, kNone};
      faces_[beyond].neighbor[SlotOpposite(beyond, tip, tail)] = f;
      face_from_[tail] = f;
      if (tail != ghost_ && tip != ghost_) latest_ = f;
    }
    for (const RimEdge& edge : rim_) {
      const Index f = face_from_[edge.tail], g = face_from_[edge.tip];
      faces_[f].neighbor[0] = g;
      faces_[g].neighbor[1] = f;
    }
  }

  int SlotOpposite(Index f, Index tail, Index tip) const {
    const Triangle& corner = faces_[f].corner;
    int k = 0;
    while (corner[(k + 1) % 3] != tail || corner[(k + 2) % 3] != tip) ++k;
    return k;
  }

  const Points& points_;
  const Index ghost_;
  std::vector<Face> faces_;
  std::vector<Index> face_from_;  ///< per rim vertex: the new face whose rim edge starts there
  std::vector<Index> cavity_;
  std::vector<RimEdge> rim_;
  Index latest_ = 0;
};

Status CheckPoints(const Points& points) {
  if (points.size() < 3) {
    return Status::InvalidInput(
        fmt::format("{} points have no triangulation; give at least 3", points.size()));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      return Status::InvalidInput(
          fmt::format("point {} has a coordinate that is not finite; remove or repair it", i));
    }
  }
  return {};
}

Status Coincidence(Index i, Index j) {
  return Status::InvalidInput(
      fmt::format("points {} and {} coincide; merge them", std::min(i, j), std::max(i, j)));
}

/// Moves to position 2 the first point in the order that is off the line of the first two, and
/// swaps those where needed: the first three then form a counter-clockwise triangle.
Status LeadWithTriangle(const Points& points, std::vector<Index>* order) {
  std::vector<Index>& o = *order;
  if (points[o[0]] == points[o[1]]) return Coincidence(o[0], o[1]);
  const auto side = [&](Index i) { return OrientationSign(points[o[0]], points[o[1]], points[i]); };
  const auto third = std::find_if(o.begin() + 2, o.end(), [&](Index i) { return side(i) != 0; });
  if (third == o.end()) {
    return Status::InvalidInput("all points lie on one line; give at least one off it");
  }
  const bool clockwise = side(*third) < 0;
  std::rotate(o.begin() + 2, third, third + 1);
  if (clockwise) std::swap(o[0], o[1]);
  return {};
}

}  // namespace

StatusOr<std::vector<Triangle>> ClosedPlanarDelaunay(const Points& points) {
  if (const Status status = CheckPoints(points); !status.ok()) return status;
  std::vector<Index> order = HilbertOrder(points);
  if (const Status status = LeadWithTriangle(points, &order); !status.ok()) return status;
  Insertion insertion(points);
  insertion.Start(order[0], order[1], order[2]);
  for (std::size_t i = 3; i < order.size(); ++i) {
    const Index twin = insertion.Insert(order[i]);
    if (twin != kNone) return Coincidence(twin, order[i]);
  }
  return insertion.Triangles();
}

StatusOr<std::vector<Triangle>> PlanarDelaunay(const Points& points) {
  auto triangles = ClosedPlanarDelaunay(points);
  if (!triangles.ok()) return triangles;
  std::erase_if(*triangles,
                [](const Triangle& t) { return std::find(t.begin(), t.end(), kNone) != t.end(); });
  return triangles;
}

std::vector<Triangle> TriangulateHull(const std::vector<Eigen::Vector2d>& points) {
  auto triangles = PlanarDelaunay(points);
  CHECK(triangles.ok()) << triangles.status().message();
  return *std::move(triangles);
}

namespace {

/// How far around the cell translates are added, in mean distances of points: every circle that
/// decides about a triangle at the cell must lie within.
constexpr double kMargin = 10;

/// Points of the plane that cover a cell and a margin around it; the cell's own come first.
struct Covering {
  std::vector<Eigen::Vector2d> point;
  std::vector<Index> original;
};

Covering Cover(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& periods) {
  const double distance = std::sqrt(periods.prod() / static_cast<double>(points.size()));
  const Eigen::Vector2d reach =
      periods / 2 + periods.cwiseMin(Eigen::Vector2d::Constant(kMargin * distance));
  const auto count = static_cast<Index>(points.size());
  Covering covering{points, {}};
  for (Index v = 0; v < count; ++v) covering.original.push_back(v);
  for (Index v = 0; v < count; ++v) {
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        const Eigen::Vector2d moved = points[v] + Eigen::Vector2d(i, j).cwiseProduct(periods);
        if ((i == 0 && j == 0) || (moved.cwiseAbs().array() > reach.array()).any()) continue;
        covering.point.push_back(moved);
        covering.original.push_back(v);
      }
    }
  }
  return covering;
}

}  // namespace

std::vector<Triangle> PeriodicDelaunay(const std::vector<Eigen::Vector2d>& points,
                                       const Eigen::Vector2d& periods) {
  const Covering covering = Cover(points, periods);
  const auto count = static_cast<Index>(points.size());
  std::vector<Triangle> representatives;
  for (const Triangle& triangle : TriangulateHull(covering.point)) {
    // Of the translates, the one whose least-numbered corner is the cell's own.
    const Index least = *std::min_element(triangle.begin(), triangle.end(), [&](Index i, Index j) {
      return covering.original[i] < covering.original[j];
    });
    if (least >= count) continue;
    Triangle& kept = representatives.emplace_back();
    std::transform(triangle.begin(), triangle.end(), kept.begin(),
                   [&](Index v) { return covering.original[v]; });
  }
  return representatives;
}

}  // namespace cirque
