#include "cirque/mesh/hole_filling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/text.h"

namespace cirque {
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
