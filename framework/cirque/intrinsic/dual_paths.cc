#include "cirque/intrinsic/dual_paths.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "cirque/core/grouping.h"

namespace cirque {
namespace {

/// Breadth-first trees of faces, one in every piece of a triangulation.
struct FaceForest {
  std::vector<Index> entered;  ///< per face the halfedge by which it is reached; a root: kNone
  std::vector<Index> depth;
};

class Grower {
 public:
  explicit Grower(const Triangulation& t) : t_(t) {
    forest_.entered.assign(t.num_faces(), kNone);
    forest_.depth.assign(t.num_faces(), kNone);
  }

  void GrowFrom(Index root) {
    if (forest_.depth[root] != kNone) return;
    forest_.depth[root] = 0;
    std::vector<Index> reached = {root};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const Index f = reached[i];
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = t_.twin[h];
        if (g == kNone || forest_.depth[Triangulation::Face(g)] != kNone) continue;
        forest_.depth[Triangulation::Face(g)] = forest_.depth[f] + 1;
        forest_.entered[Triangulation::Face(g)] = g;
        reached.push_back(Triangulation::Face(g));
      }
    }
  }

  FaceForest Take() { return std::move(forest_); }

 private:
  const Triangulation& t_;
  FaceForest forest_;
};

/// Trees rooted at the first of `first_roots` in each piece, in pieces without one at any face.
FaceForest GrowForest(const Triangulation& t, const std::vector<Index>& first_roots) {
  Grower grower(t);
  for (const Index f : first_roots) grower.GrowFrom(f);
  for (Index f = 0; f < t.num_faces(); ++f) grower.GrowFrom(f);
  return grower.Take();
}

Index Parent(const Triangulation& t, const FaceForest& forest, Index f) {
  return Triangulation::Face(t.twin[forest.entered[f]]);
}

/// The halfedges entered on the way from a face's ancestor down to it.
std::vector<Index> WayDown(const Triangulation& t, const FaceForest& forest, Index ancestor,
                           Index f) {
  std::vector<Index> way;
  for (; f != ancestor; f = Parent(t, forest, f)) way.push_back(forest.entered[f]);
  std::reverse(way.begin(), way.end());
  return way;
}

Index CommonAncestor(const Triangulation& t, const FaceForest& forest, Index a, Index b) {
  while (a != b) {
    Index& deeper = forest.depth[a] >= forest.depth[b] ? a : b;
    deeper = Parent(t, forest, deeper);
  }
  return a;
}

Index Root(const Triangulation& t, const FaceForest& forest, Index f) {
  while (forest.entered[f] != kNone) f = Parent(t, forest, f);
  return f;
}

/// Down the tree to the face of h, across h, and back up.
DualPath LoopThrough(const Triangulation& t, const FaceForest& forest, Index h) {
  const Index a = Triangulation::Face(h), b = Triangulation::Face(t.twin[h]);
  const Index top = CommonAncestor(t, forest, a, b);
  DualPath loop{WayDown(t, forest, top, a), kNone};
  loop.entered.push_back(t.twin[h]);
  for (Index f = b; f != top; f = Parent(t, forest, f)) {
    loop.entered.push_back(t.twin[forest.entered[f]]);
  }
  return loop;
}

/// Interior edges not crossed by the forest, by the length of the loops that they close.
std::vector<Index> EdgesByLoop(const Triangulation& t, const FaceForest& forest) {
  std::vector<bool> crossed(t.num_edges(), false);
  for (const Index h : forest.entered) {
    if (h != kNone) crossed[t.edge[h]] = true;
  }
  std::vector<std::pair<Index, Index>> keyed;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (crossed[e] || t.IsBoundaryEdge(e)) continue;
    const Index h = t.edge_halfedge[e];
    keyed.emplace_back(
        forest.depth[Triangulation::Face(h)] + forest.depth[Triangulation::Face(t.twin[h])], e);
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<Index> edges;
  for (const auto& [length, e] : keyed) edges.push_back(e);
  return edges;
}

}  // namespace

std::vector<DualPath> HandleLoops(const Triangulation& t) {
  if (t.num_faces() == 0) return {};
  const FaceForest forest = GrowForest(t, {});
  DisjointSets joined(t.num_vertices);
  for (const Index h : t.edge_halfedge) {
    if (t.twin[h] == kNone) joined.Unite(t.Tail(h), t.Tip(h));
  }
  const std::vector<Index> edges = EdgesByLoop(t, forest);
  std::vector<DualPath> loops;
  for (auto e = edges.rbegin(); e != edges.rend(); ++e) {
    const Index h = t.edge_halfedge[*e];
    if (!joined.Unite(t.Tail(h), t.Tip(h))) loops.push_back(LoopThrough(t, forest, h));
  }
  return loops;
}

std::vector<DualPath> BoundaryPaths(const Triangulation& t) {
  std::vector<Index> ends, faces;
  for (const std::vector<Index>& loop : BoundaryLoops(t)) {
    ends.push_back(loop.front());
    faces.push_back(Triangulation::Face(loop.front()));
  }
  if (ends.size() < 2) return {};
  const FaceForest forest = GrowForest(t, faces);
  std::map<Index, Index> start;  // per root the first loop's end in its piece
  std::vector<DualPath> paths;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const Index root = Root(t, forest, faces[k]);
    const auto [first, is_first] = start.try_emplace(root, ends[k]);
    if (is_first) continue;
    DualPath path{{first->second}, ends[k]};
    for (const Index h : WayDown(t, forest, root, faces[k])) path.entered.push_back(h);
    paths.push_back(std::move(path));
  }
  return paths;
}

SignedCorners CornersAlong(const Triangulation& t, const DualPath& path) {
  SignedCorners corners;
  for (std::size_t i = 0; i < path.entered.size(); ++i) {
    const Index h = path.entered[i];
    const bool last = i + 1 == path.entered.size();
    const Index left_by =
        last && !path.IsClosed() ? path.exit : t.twin[path.entered[last ? 0 : i + 1]];
    const bool right = left_by == Triangulation::Next(h);
    corners.emplace_back(right ? Triangulation::Prev(h) : Triangulation::Next(h), right ? -1 : 1);
  }
  return corners;
}

double RotationAlong(const SignedCorners& corners, const Eigen::VectorXd& angles) {
  double rotation = 0;
  for (const auto& [corner, sign] : corners) rotation += sign * angles[corner];
  return rotation;
}

double RotationAround(const Triangulation& t, const std::vector<Index>& loop,
                      const std::vector<double>& angle_sums) {
  double rotation = 0;
  for (const Index h : loop) rotation += kPi - angle_sums[t.Tip(h)];
  return rotation;
}

double BeyondMultiple(double x, double unit) { return x - unit * std::round(x / unit); }

}  // namespace cirque
