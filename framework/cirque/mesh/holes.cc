#include "cirque/mesh/holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/text.h"
#include "cirque/core/triangulation.h"

namespace cirque {

SubTriangulation KeepFaces(const Triangulation& whole, const std::vector<bool>& keep) {
  SubTriangulation part;
  part.of_vertex.assign(whole.num_vertices, kNone);
  std::vector<Index> number(whole.num_faces(), kNone);
  for (Index f = 0; f < whole.num_faces(); ++f) {
    if (!keep[f]) continue;
    number[f] = static_cast<Index>(part.face.size());
    part.face.push_back(f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) part.of_vertex[whole.vertex[h]] = 0;
  }
  for (Index v = 0; v < whole.num_vertices; ++v) {
    if (part.of_vertex[v] == kNone) continue;
    part.of_vertex[v] = static_cast<Index>(part.vertex.size());
    part.vertex.push_back(v);
  }
  std::vector<Index> vertex, twin;
  for (Index h = 0; h < 3 * static_cast<Index>(part.face.size()); ++h) {
    const Index g = whole.twin[part.Halfedge(h)];
    const Index across = g == kNone ? kNone : number[g / 3];
    vertex.push_back(part.of_vertex[whole.vertex[part.Halfedge(h)]]);
    twin.push_back(across == kNone ? kNone : 3 * across + g % 3);
  }
  part.triangulation =
      NumberEdges(static_cast<Index>(part.vertex.size()), std::move(vertex), std::move(twin));
  return part;
}

EdgeLengths LengthsOf(const SubTriangulation& part, const Triangulation& whole,
                      const EdgeLengths& lengths) {
  const Triangulation& t = part.triangulation;
  EdgeLengths own = {Eigen::VectorXd(t.num_edges())};
  for (Index e = 0; e < t.num_edges(); ++e) {
    own.value[e] = lengths.value[whole.edge[part.Halfedge(t.edge_halfedge[e])]];
  }
  return own;
}

std::vector<bool> LargestChordlessPiece(const Triangulation& disk,
                                        const std::vector<bool>& boundary) {
  Triangulation cut = disk;
  for (Index h = 0; h < disk.num_halfedges(); ++h) {
    if (boundary[disk.Tail(h)] && boundary[disk.Tip(h)]) cut.twin[h] = kNone;
  }
  const Patches pieces = ConnectedPatches(cut);
  std::vector<Index> size(pieces.count, 0);
  for (const Index piece : pieces.of_face) ++size[piece];
  const auto largest =
      static_cast<Index>(std::max_element(size.begin(), size.end()) - size.begin());
  std::vector<bool> keep;
  for (const Index piece : pieces.of_face) keep.push_back(piece == largest);
  return keep;
}

namespace {

Index FirstCorner(const Triangulation& t, Index v) {
  const auto found = std::find(t.vertex.begin(), t.vertex.end(), v);
  CHECK(found != t.vertex.end()) << "vertex " << v << " has no corner";
  return static_cast<Index>(found - t.vertex.begin());
}

}  // namespace

bool HasDiskStar(const Triangulation& t, Index corner) {
  std::vector<Index> closed = {t.vertex[corner]};
  t.ForEachCornerAround(corner, [&](Index c) { closed.push_back(t.Tail(c)); });
  std::sort(closed.begin(), closed.end());
  return closed.size() > 3 && std::adjacent_find(closed.begin(), closed.end()) == closed.end();
}

StatusOr<PuncturedSurface> Puncture(const Triangulation& t, Index pole) {
  const Index corner = FirstCorner(t, pole);
  if (!HasDiskStar(t, corner)) {
    return Status::InvalidInput(
        fmt::format("the triangles around vertex {} (0-based) form no disk; take another", pole));
  }
  PuncturedSurface punctured;
  punctured.pole = pole;
  std::vector<bool> keep(t.num_faces(), true);
  t.ForEachCornerAround(corner, [&](Index c) {
    keep[Triangulation::Face(c)] = false;
    punctured.link.push_back(t.Tail(c));
  });
  if (std::find(keep.begin(), keep.end(), true) == keep.end()) {
    return Status::InvalidInput("all triangles meet in one vertex; there is nothing to map");
  }
  static_cast<SubTriangulation&>(punctured) = KeepFaces(t, keep);
  return punctured;
}

namespace {

using Loop = std::vector<Index>;  // halfedges, the surface on their left

/// Twice the area over the square of the longest edge: 0.87 for the regular triangle.
double Roundness(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  if (!(longest > 0)) return 0;
  const Eigen::Vector3d u = (b - a) / longest, v = (c - a) / longest;
  return u.cross(v).norm();
}

constexpr double kRound = 0.05;   // below it a fill triangle is a sliver, to be avoided
constexpr double kNoArea = 1e-9;  // below it, it is of no use

class HoleFiller {
 public:
  explicit HoleFiller(const Surface& input)
      : input_(input), vertex_(input.triangulation.vertex), twin_(input.triangulation.twin) {
    filled_.surface = input;
    filled_.num_input_faces = input.triangulation.num_faces();
    filled_.num_input_vertices = input.triangulation.num_vertices;
  }

  Status Fill(const Loop& loop) {
    ++filled_.num_filled_loops;
    if (loop.size() == 3 && IsTriangleHole(loop)) {
      AddTriangle(loop);
      return Status();
    }
    return AddFan(loop);
  }

  FilledSurface Finish() && {
    Surface& surface = filled_.surface;
    surface.soup_vertex.resize(surface.position.size(), kNone);
    surface.soup_polygon.resize(vertex_.size() / 3, kNone);
    surface.soup_corner.resize(vertex_.size(), kNone);
    surface.triangulation = NumberEdges(static_cast<Index>(surface.position.size()),
                                        std::move(vertex_), std::move(twin_));
    return std::move(filled_);
  }

 private:
  Index Tail(Index h) const { return input_.triangulation.Tail(h); }
  Index Tip(Index h) const { return input_.triangulation.Tip(h); }
  const Eigen::Vector3d& At(Index v) const { return input_.position[v]; }

  bool IsTriangleHole(const Loop& loop) const {
    const bool is_lone_face = Triangulation::Face(loop[0]) == Triangulation::Face(loop[1]) &&
                              Triangulation::Face(loop[1]) == Triangulation::Face(loop[2]);
    return !is_lone_face &&
           Roundness(At(Tail(loop[0])), At(Tail(loop[1])), At(Tail(loop[2]))) > kRound;
  }

  void Glue(Index h, Index g) {
    twin_[h] = g;
    twin_[g] = h;
  }

  /// A face with these corners, not glued yet. Returns its first halfedge.
  Index AddFace(const std::array<Index, 3>& corners) {
    const auto first = static_cast<Index>(vertex_.size());
    vertex_.insert(vertex_.end(), corners.begin(), corners.end());
    twin_.insert(twin_.end(), 3, kNone);
    return first;
  }

  void AddTriangle(const Loop& loop) {
    // Against the loop's direction: tail of the third, of the second, of the first.
    const Index f = AddFace({Tail(loop[2]), Tail(loop[1]), Tail(loop[0])});
    Glue(f, loop[0]);      // from the tail of the second to that of the first
    Glue(f + 1, loop[2]);  // from the first to the third
    Glue(f + 2, loop[1]);  // from the third to the second
  }

  Status AddFan(const Loop& loop) {
    const Eigen::Vector3d apex = ChooseApex(loop);
    if (!(LeastRoundness(loop, apex) > kNoArea)) {
      std::vector<int> vertices;
      for (const Index h : loop) vertices.push_back(input_.soup_vertex[Tail(h)] + 1);
      return Status::InvalidInput(fmt::format(
          "the hole at the vertices {} (counted from 1) cannot be filled: its edges are too close "
          "to one line or point for double coordinates; repair it or leave it open",
          IdList(vertices)));
    }
    const auto centre = static_cast<Index>(filled_.surface.position.size());
    filled_.surface.position.push_back(apex);
    const auto first = static_cast<Index>(vertex_.size());
    const auto n = static_cast<Index>(loop.size());
    for (Index i = 0; i < n; ++i) {
      // Side 0 lies against the loop's edge, side 1 runs from its tail to the centre, side 2 from
      // the centre to its tip.
      const Index f = AddFace({centre, Tip(loop[i]), Tail(loop[i])});
      Glue(f, loop[i]);
    }
    for (Index i = 0; i < n; ++i) Glue(first + 3 * i + 2, first + 3 * ((i + 1) % n) + 1);
    return Status();
  }

  double LeastRoundness(const Loop& loop, const Eigen::Vector3d& apex) const {
    double least = 1;
    for (const Index h : loop) least = std::min(least, Roundness(At(Tail(h)), At(Tip(h)), apex));
    return least;
  }

  /// The mean, or the first point above it from where no triangle is a sliver, or the best of them.
  Eigen::Vector3d ChooseApex(const Loop& loop) const {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(), area = Eigen::Vector3d::Zero();
    for (const Index h : loop) mean += At(Tail(h)) / static_cast<double>(loop.size());
    double radius = 0;
    for (const Index h : loop) radius = std::max(radius, (At(Tail(h)) - mean).norm());
    for (const Index h : loop) {
      area += ((At(Tail(h)) - mean) / radius).cross((At(Tip(h)) - mean) / radius);
    }
    Eigen::Vector3d best = mean;
    double best_roundness = LeastRoundness(loop, mean);
    for (const Eigen::Vector3d& direction :
         {area, Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
      for (const double height : {0.25, 0.5, 1.}) {
        if (best_roundness > kRound) return best;
        const Eigen::Vector3d apex = mean + height * radius * direction.stableNormalized();
        const double roundness = LeastRoundness(loop, apex);
        if (roundness > best_roundness) {
          best = apex;
          best_roundness = roundness;
        }
      }
    }
    return best;
  }

  const Surface& input_;
  std::vector<Index> vertex_, twin_;
  FilledSurface filled_;
};

double Length(const Surface& surface, const Loop& loop) {
  const Triangulation& t = surface.triangulation;
  double length = 0;
  for (const Index h : loop)
    length += (surface.position[t.Tip(h)] - surface.position[t.Tail(h)]).norm();
  return length;
}

}  // namespace

StatusOr<FilledSurface> FillHoles(const Surface& surface, KeptLoops kept) {
  std::vector<Loop> loops = BoundaryLoops(surface.triangulation);
  if (kept == KeptLoops::kLongest && !loops.empty()) {
    loops.erase(std::max_element(loops.begin(), loops.end(), [&](const Loop& a, const Loop& b) {
      return Length(surface, a) < Length(surface, b);
    }));
  }
  HoleFiller filler(surface);
  for (const Loop& loop : loops) {
    if (Status s = filler.Fill(loop); !s.ok()) return s;
  }
  return std::move(filler).Finish();
}

CornerUv WithoutFill(const FilledSurface& filled, const CornerUv& uv) {
  CHECK_EQ(uv.value.size(), filled.surface.triangulation.vertex.size());
  return {{uv.value.begin(), uv.value.begin() + 3 * filled.num_input_faces}};
}

}  // namespace cirque
