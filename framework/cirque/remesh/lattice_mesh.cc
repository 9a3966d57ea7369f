#include "cirque/remesh/lattice_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "cirque/remesh/even_triangles.h"

namespace cirque {
namespace {

using Point = Eigen::Vector2d;
using Kind = FlatMesh::Kind;

constexpr double kSame = 1e-6;    ///< [cells]: lattice points this near to a vertex are there
constexpr double kOnEdge = 1e-9;  ///< [cells]: and to an edge, on it
constexpr double kLeastHeight = 1e-7;
constexpr int kMostPasses = 200;

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

class LatticeMesher {
 public:
  LatticeMesher(const FlatDomain& domain, LatticeKind kind, const LatticeMap& map)
      : domain_(domain), kind_(kind), map_(map), mesh_(domain, {}) {}

  Status Insert() {
    for (Index f = 0; f < domain_.triangulation().num_faces(); ++f) {
      const RigidMotion to_frame =
          RigidMotion::Aligning(map_.uv.value[3 * f], map_.uv.value[3 * f + 1],
                                domain_.Corner(3 * f), domain_.Corner(3 * f + 1));
      for (const Point& p : PointsOver(f)) {
        if (!InsertAt(f, to_frame(p)))
          return {StatusCode::kNotConverged, "a point of the lattice was lost to rounding"};
      }
    }
    return Status();
  }

  Status RemoveOthers(const SolveControl& control) {
    const auto never = [](Index, Index, double) { return false; };
    for (int pass = 0; pass < kMostPasses; ++pass) {
      if (control.cancelled != nullptr && control.cancelled->load())
        return {StatusCode::kCancelled, "remeshing was cancelled"};
      Index left = 0;
      for (Index v = 0; v < mesh_.num_vertices(); ++v) {
        if (IsOnLattice(v) || mesh_.vertex(v).IsGone()) continue;
        if (!Remove(v, never)) ++left;
      }
      FlipToDelaunay(&mesh_);
      if (left == 0) return Check();
    }
    return Check();
  }

  FlatMesh Take() { return std::move(mesh_); }

 private:
  bool IsOnLattice(Index v) const {
    return v < static_cast<Index>(on_lattice_.size()) && on_lattice_[v];
  }

  void Mark(Index v) {
    on_lattice_.resize(std::max<std::size_t>(on_lattice_.size(), v + 1), false);
    on_lattice_[v] = true;
  }

  /// The lattice's points on a face of the map and its border.
  std::vector<Point> PointsOver(Index f) const {
    const Point* uv = &map_.uv.value[3 * f];
    const Point lower = uv[0].cwiseMin(uv[1]).cwiseMin(uv[2]);
    const Point upper = uv[0].cwiseMax(uv[1]).cwiseMax(uv[2]);
    const double height = kind_ == LatticeKind::kSquares ? 1 : std::sqrt(3.) / 2;
    std::vector<Point> points;
    for (double j = std::floor(lower.y() / height); j <= std::ceil(upper.y() / height); ++j) {
      const double shift = kind_ == LatticeKind::kSquares ? 0 : j / 2;
      for (double i = std::floor(lower.x() - shift); i <= std::ceil(upper.x() - shift); ++i) {
        const Point p(i + shift, j * height);
        bool is_inside = true;
        for (int k = 0; k < 3; ++k) {
          const Point &a = uv[k], &b = uv[(k + 1) % 3];
          is_inside = is_inside && Cross(a, b, p) >= -kSame * (b - a).norm();
        }
        if (is_inside) points.push_back(p);
      }
    }
    return points;
  }

  /// Walks to the triangle that has a point, given in the frame of a face of the domain.
  bool InsertAt(Index f, const Point& at) {
    Index face = f;
    RigidMotion motion;  // from the frame of f to that of the triangle
    const auto most = mesh_.num_halfedges();
    for (Index step = 0; step < most; ++step) {
      const Point p = motion(at);
      Index out = kNone, near = kNone;
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        const Point a = mesh_.Position(Next(h)), b = mesh_.Position(Prev(h));
        if ((a - p).norm() < kSame) {
          Mark(mesh_.VertexAt(Next(h)));
          return true;
        }
        const double height = Cross(a, b, p) / (b - a).norm();
        if (height < -kOnEdge) out = h;
        if (std::abs(height) <= kOnEdge) near = h;
      }
      if (out == kNone) return Put(face, near, {f, at}, motion);
      const Index twin = mesh_.Twin(out);
      motion = mesh_.Across(twin) * motion;
      face = Triangulation::Face(twin);
    }
    return false;
  }

  bool Put(Index face, Index edge, const FlatPoint& point, const RigidMotion& to_face) {
    Mark(edge == kNone ? mesh_.InsertInside(face, point, to_face)
                       : mesh_.SplitAt(edge, point, to_face));
    return true;
  }

  bool Remove(Index v, const FlatMesh::TooLong& too_long) {
    if (mesh_.vertex(v).kind == Kind::kCone) return false;
    for (const Index c : mesh_.CornersAround(v)) {
      if (mesh_.Collapse(Prev(c), false, kLeastHeight, too_long)) return true;
    }
    // Fewer edges at it, for the next time.
    for (const Index c : mesh_.CornersAround(v)) {
      if (mesh_.VertexAt(c) == v && mesh_.Flip(Prev(c))) break;
    }
    return false;
  }

  Status Check() const {
    Index others = 0, faces = 0, cells = 0;
    for (Index v = 0; v < mesh_.num_vertices(); ++v)
      others += mesh_.vertex(v).IsGone() || IsOnLattice(v) ? 0 : 1;
    const double area = kind_ == LatticeKind::kSquares ? 1 : std::sqrt(3.) / 2;
    for (Index f = 0; 3 * f < mesh_.num_halfedges(); ++f) {
      if (mesh_.IsGone(3 * f)) continue;
      ++faces;
      cells += std::abs(mesh_.TwiceArea(f) - area) < kSame ? 1 : 0;
    }
    if (others == 0 && faces == cells) return Status();
    return {StatusCode::kNotConverged,
            fmt::format("the lattice: {} vertices beside it and {} of {} triangles that are no "
                        "cells remain, as where cells would have more than an edge in common; ask "
                        "for shorter edges",
                        others, faces - cells, faces)};
  }

  const FlatDomain& domain_;
  LatticeKind kind_;
  const LatticeMap& map_;
  FlatMesh mesh_;
  std::vector<bool> on_lattice_;
};

}  // namespace

StatusOr<FlatMesh> MakeLatticeMesh(const FlatDomain& domain, LatticeKind kind,
                                   const LatticeMap& map, const SolveControl& control) {
  LatticeMesher mesher(domain, kind, map);
  if (Status s = mesher.Insert(); !s.ok()) return s;
  if (Status s = mesher.RemoveOthers(control); !s.ok()) return s;
  return mesher.Take();
}

std::vector<std::array<Index, 4>> SquaresOf(const FlatMesh& mesh) {
  std::vector<std::array<Index, 4>> squares;
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    if (mesh.IsGone(h) || mesh.Twin(h) < h || mesh.Length(h) < 1.2) continue;
    squares.push_back({h, Next(h), mesh.Twin(h), Prev(h)});
  }
  return squares;
}

}  // namespace cirque
