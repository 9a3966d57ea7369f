#include "cirque/cuts/dual_graph.h"

#include <cmath>

namespace cirque {
namespace {

/// A side of a face in its plane, from (0, 0) along x: where its centroid lies.
Eigen::Vector2d CentroidBeside(const IntrinsicSurface& surface, Index h) {
  const auto length = [&](Index i) { return surface.lengths.value[surface.triangulation.edge[i]]; };
  const double base = length(h), left = length(Triangulation::Prev(h));
  const double angle = surface.angles.value[Triangulation::Next(h)];  // at the tail of h
  const Eigen::Vector2d apex(left * std::cos(angle), left * std::sin(angle));
  return (Eigen::Vector2d(base, 0) + apex) / 3;
}

double FaceArea(const IntrinsicSurface& surface, Index f) {
  const auto& length = surface.lengths.value;
  const auto& edge = surface.triangulation.edge;
  return 0.5 * length[edge[3 * f + 1]] * length[edge[3 * f + 2]] *
         std::sin(surface.angles.value[3 * f]);
}

/// The distance of the centroids on the two sides of an edge, straight across it.
double DistanceAcross(const IntrinsicSurface& surface, Index h) {
  const Triangulation& t = surface.triangulation;
  const Eigen::Vector2d here = CentroidBeside(surface, h);
  const Eigen::Vector2d there = CentroidBeside(surface, t.twin[h]);
  const double base = surface.lengths.value[t.edge[h]];
  return std::hypot(here.x() - (base - there.x()), here.y() + there.y());
}

}  // namespace

DualGraph::DualGraph(const IntrinsicSurface& surface, const Eigen::VectorXd& cost, const Cut& given)
    : of_face_(surface.triangulation.num_faces()) {
  Number(surface.triangulation, cost, given);
  area_.assign(size_, 0);
  for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
    area_[of_face_[f]] += FaceArea(surface, f);
  }
  std::vector<Index> end;
  for (Index e = 0; e < surface.triangulation.num_edges(); ++e) {
    if (surface.triangulation.IsBoundaryEdge(e) || given.edge[e]) continue;
    const Index h = surface.triangulation.edge_halfedge[e];
    const Index a = of_face_[Triangulation::Face(h)];
    const Index b = of_face_[Triangulation::Face(surface.triangulation.twin[h])];
    if (a == b) continue;
    joints_.push_back({e, a, b, cost[e], DistanceAcross(surface, h)});
    end.push_back(a), end.push_back(b);
  }
  ends_ = SortIntoBuckets(end, size_);
}

void DualGraph::Number(const Triangulation& t, const Eigen::VectorXd& cost, const Cut& given) {
  DisjointSets polygons(t.num_faces());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    if (t.IsBoundaryEdge(e) || given.edge[e] || std::isfinite(cost[e])) continue;
    polygons.Unite(Triangulation::Face(h), Triangulation::Face(t.twin[h]));
  }
  for (Index f = 0; f < t.num_faces(); ++f) {
    const Index first = polygons.Find(f);
    of_face_[f] = first == f ? size_++ : of_face_[first];
  }
}

}  // namespace cirque
