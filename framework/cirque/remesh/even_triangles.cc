#include "cirque/remesh/even_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

namespace cirque {
namespace {

using Point = Eigen::Vector2d;
using Kind = FlatMesh::Kind;

constexpr double kLong = 4. / 3, kShort = 4. / 5;  ///< of the length asked for
constexpr double kLeastHeight = 0.05;  ///< of triangles, as a part of their longest side
constexpr double kDelaunay = 1e-9;     ///< [rad]
constexpr int kMostPasses = 40;

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

/// Each edge by one of its halfedges.
bool StandsForEdge(const FlatMesh& mesh, Index h) {
  return !mesh.IsGone(h) && (mesh.Twin(h) == kNone || h < mesh.Twin(h));
}

double AngleAt(const FlatMesh& mesh, Index corner) {
  const Point a = mesh.Position(Next(corner)) - mesh.Position(corner);
  const Point b = mesh.Position(Prev(corner)) - mesh.Position(corner);
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

class Remesher {
 public:
  Remesher(const SizeField& field, FlatMesh* mesh) : field_(field), mesh_(*mesh) { Measure(); }

  void Round() {
    SplitLong();
    CollapseShort();
    EqualizeValences();
    Smooth();
    FlipToDelaunay(&mesh_);
  }

  void Polish() {
    Smooth();
    FlipToDelaunay(&mesh_);
  }

  /// Splits what keeps the mesh from being simplicial.
  bool MakeSimple() {
    for (int pass = 0; pass < kMostPasses; ++pass) {
      const std::vector<Index> edges = EdgesAgainstSimplicity(mesh_);
      if (edges.empty()) return true;
      for (const Index h : edges) mesh_.Split(h);
      Measure();
      FlipToDelaunay(&mesh_);
    }
    return EdgesAgainstSimplicity(mesh_).empty();
  }

 private:
  void Measure() {
    for (auto v = static_cast<Index>(size_.size()); v < mesh_.num_vertices(); ++v) {
      size_.push_back(field_.At(mesh_.vertex(v).point));
    }
  }

  double Wanted(Index a, Index b) const { return std::sqrt(size_[a] * size_[b]); }
  double Ratio(Index h) const { return mesh_.Length(h) / Wanted(mesh_.Tail(h), mesh_.Tip(h)); }

  /// The longest first: splits renumber the other sides of their triangles, and in any other order
  /// some edges would never have their turn.
  void SplitLong() {
    for (int pass = 0; pass < kMostPasses; ++pass) {
      std::vector<std::pair<double, Index>> edges;
      for (Index h = 0; h < mesh_.num_halfedges(); ++h) {
        if (StandsForEdge(mesh_, h) && Ratio(h) > kLong) edges.emplace_back(-Ratio(h), h);
      }
      std::sort(edges.begin(), edges.end());
      int count = 0;
      for (const auto& [ratio, h] : edges) {
        if (Ratio(h) <= kLong || mesh_.Split(h) == kNone) continue;
        Measure();
        ++count;
      }
      if (count == 0) return;
      FlipToDelaunay(&mesh_);
    }
  }

  void CollapseShort() {
    const FlatMesh::TooLong too_long = [this](Index a, Index b, double length) {
      return length > kLong * Wanted(a, b);
    };
    for (int pass = 0; pass < kMostPasses; ++pass) {
      int count = 0;
      for (Index h = 0; h < mesh_.num_halfedges(); ++h) {
        if (!StandsForEdge(mesh_, h) || Ratio(h) >= kShort) continue;
        if (mesh_.Collapse(h, false, kLeastHeight, too_long) ||
            mesh_.Collapse(h, true, kLeastHeight, too_long)) {
          ++count;
        }
      }
      if (count == 0) return;
      FlipToDelaunay(&mesh_);
    }
  }

  /// How far a vertex is from six edges, or from what its angle sum has of them.
  int Excess(Index v) const {
    const auto degree = static_cast<int>(mesh_.Neighbours(v).size());
    if (mesh_.vertex(v).kind == Kind::kFree) return degree - 6;
    double sum = 0;
    for (const Index c : mesh_.CornersAround(v)) sum += AngleAt(mesh_, c);
    const int corners = std::max(1, static_cast<int>(std::lround(3 * sum / kPi)));
    return degree - (mesh_.vertex(v).IsOnBoundary() ? corners + 1 : std::max(3, corners));
  }

  void EqualizeValences() {
    for (Index h = 0; h < mesh_.num_halfedges(); ++h) {
      if (!StandsForEdge(mesh_, h) || mesh_.Twin(h) == kNone) continue;
      const int a = Excess(mesh_.Tail(h)), b = Excess(mesh_.Tip(h));
      const int c = Excess(mesh_.VertexAt(h)), d = Excess(mesh_.VertexAt(mesh_.Twin(h)));
      const int change = 2 * (c + d - a - b) + 4;  // of the sum of squares
      if (change >= 0 || !IsWellAfterFlip(h)) continue;
      mesh_.Flip(h);
    }
  }

  /// Whether the triangles that a flip would make are no slivers.
  bool IsWellAfterFlip(Index h) const {
    const Index t = mesh_.Twin(h);
    const Point c = mesh_.Position(h), a = mesh_.Position(Next(h)), b = mesh_.Position(Prev(h));
    const Point d = mesh_.Across(h)(mesh_.Position(t));
    const double longest = std::max({(c - d).squaredNorm(), (a - b).squaredNorm()});
    return Cross(c, a, d) > 0.3 * longest && Cross(d, b, c) > 0.3 * longest;
  }

  void Smooth() {
    for (Index v = 0; v < mesh_.num_vertices(); ++v) {
      if (mesh_.vertex(v).IsGone()) continue;
      if (mesh_.vertex(v).kind == Kind::kFree) SmoothInside(v);
      if (mesh_.vertex(v).kind == Kind::kOnBoundary) SmoothOnBoundary(v);
    }
  }

  void SmoothInside(Index v) {
    Point sum(0, 0);
    double mass = 0;
    for (const Index c : mesh_.CornersAround(v)) {
      const Point at = mesh_.Position(c), right = mesh_.Position(Next(c)),
                  left = mesh_.Position(Prev(c));
      const double mean =
          std::cbrt(size_[v] * size_[mesh_.VertexAt(Next(c))] * size_[mesh_.VertexAt(Prev(c))]);
      const double weight = Cross(at, right, left) * std::pow(size_[v] / mean, 4);
      sum += weight * mesh_.ToFace(c).Inverse()((at + right + left) / 3);
      mass += weight;
    }
    const Point from = mesh_.vertex(v).point.at, step = sum / mass - from;
    for (const double part : {1., 0.5, 0.25}) {
      if (!mesh_.Move(v, from + part * step, kLeastHeight)) continue;
      size_[v] = field_.At(mesh_.vertex(v).point);
      return;
    }
  }

  void SmoothOnBoundary(Index v) {
    const std::vector<Index> around = mesh_.CornersAround(v);
    const Index next = mesh_.VertexAt(Next(around.front()));
    const Index previous = mesh_.VertexAt(Prev(around.back()));
    const FlatMesh::Vertex& vertex = mesh_.vertex(v);
    const double whole = mesh_.domain().loops()[vertex.loop].length();
    const auto ahead = [whole](double from, double to) {
      return to > from ? to - from : to + whole - from;
    };
    const double behind = ahead(mesh_.vertex(previous).distance, vertex.distance);
    const double before = ahead(vertex.distance, mesh_.vertex(next).distance);
    const double a = size_[previous] + size_[v], b = size_[v] + size_[next];
    const double step = (behind + before) * a / (a + b) - behind;
    for (const double part : {1., 0.5}) {
      if (!mesh_.Slide(v, vertex.distance + part * step, kLeastHeight)) continue;
      size_[v] = field_.At(mesh_.vertex(v).point);
      return;
    }
  }

  const SizeField& field_;
  FlatMesh& mesh_;
  std::vector<double> size_;  ///< per vertex
};

}  // namespace

double SizeField::At(const FlatPoint& point) const {
  const Eigen::Vector3d weight = domain_.Barycentric(point);
  const Index* v = &domain_.triangulation().vertex[3 * point.face];
  return std::exp(weight[0] * log_size_[v[0]] + weight[1] * log_size_[v[1]] +
                  weight[2] * log_size_[v[2]]);
}

double MeanLengthRatio(const SizeField& size, const FlatMesh& mesh) {
  double sum = 0;
  std::int64_t edges = 0;
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    if (!StandsForEdge(mesh, h)) continue;
    const double wanted =
        size.At(mesh.vertex(mesh.Tail(h)).point) * size.At(mesh.vertex(mesh.Tip(h)).point);
    sum += mesh.Length(h) / std::sqrt(wanted);
    ++edges;
  }
  return sum / static_cast<double>(edges);
}

void FlipToDelaunay(FlatMesh* mesh) {
  std::vector<Index> stack;
  for (Index h = 0; h < mesh->num_halfedges(); ++h) {
    if (StandsForEdge(*mesh, h) && mesh->Twin(h) != kNone) stack.push_back(h);
  }
  std::int64_t left = 100 * static_cast<std::int64_t>(stack.size());
  while (!stack.empty() && left-- > 0) {
    const Index h = stack.back();
    stack.pop_back();
    const Index t = mesh->Twin(h);
    if (mesh->IsGone(h) || t == kNone) continue;
    if (AngleAt(*mesh, h) + AngleAt(*mesh, t) <= kPi + kDelaunay || !mesh->Flip(h)) continue;
    for (const Index face : {Triangulation::Face(h), Triangulation::Face(t)}) {
      for (Index side = 3 * face; side < 3 * face + 3; ++side) {
        if (mesh->Twin(side) != kNone) stack.push_back(side);
      }
    }
  }
}

std::vector<Index> EdgesAgainstSimplicity(const FlatMesh& mesh) {
  std::vector<std::array<Index, 3>> edges;
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    if (!StandsForEdge(mesh, h)) continue;
    edges.push_back({std::min(mesh.Tail(h), mesh.Tip(h)), std::max(mesh.Tail(h), mesh.Tip(h)), h});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Index> against;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b, h] = edges[i];
    const bool again = i > 0 && edges[i - 1][0] == a && edges[i - 1][1] == b;
    if (a == b || again) against.push_back(h);
  }
  return against;
}

Status MakeEvenTriangles(const SizeField& size, int rounds, const SolveControl& control,
                         FlatMesh* mesh) {
  constexpr int kPolish = 5;
  Remesher remesher(size, mesh);
  for (int round = 0; round < rounds; ++round) {
    if (control.cancelled != nullptr && control.cancelled->load())
      return {StatusCode::kCancelled, "remeshing was cancelled"};
    remesher.Round();
  }
  for (int i = 0; i < kPolish; ++i) remesher.Polish();
  if (remesher.MakeSimple()) return Status();
  return {StatusCode::kNotConverged,
          fmt::format("remeshing: {} edges are loops or join the same two vertices, and rounding "
                      "keeps them from being split; ask for shorter edges",
                      EdgesAgainstSimplicity(*mesh).size())};
}

}  // namespace cirque
