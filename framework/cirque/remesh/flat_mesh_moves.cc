// What moves vertices of a FlatMesh and takes them away: Collapse, Move and Slide of flat_mesh.h.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "cirque/remesh/flat_mesh.h"

namespace cirque {
namespace {

using Point = Eigen::Vector2d;

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }
Index Face(Index h) { return Triangulation::Face(h); }

}  // namespace

/// The link condition: the triangles at the edge are all that its ends have in common.
bool FlatMesh::MayCollapse(Index h, Index gone, Index kept) const {
  const Vertex& vertex = vertices_[gone];
  const Index twin = Twin(h);
  if (gone == kept || vertex.kind == Kind::kCone || vertex.kind == Kind::kFixedOnBoundary ||
      (vertex.IsOnBoundary() && twin != kNone)) {
    return false;
  }
  std::vector<Index> beside = Neighbours(gone), beside_kept = Neighbours(kept);
  std::sort(beside.begin(), beside.end());
  std::sort(beside_kept.begin(), beside_kept.end());
  for (const auto& list : {beside, beside_kept}) {
    if (std::adjacent_find(list.begin(), list.end()) != list.end()) return false;
  }
  if (std::binary_search(beside.begin(), beside.end(), gone)) return false;
  std::vector<Index> common, apexes = {VertexAt(h)};
  if (twin != kNone) apexes.push_back(VertexAt(twin));
  std::set_intersection(beside.begin(), beside.end(), beside_kept.begin(), beside_kept.end(),
                        std::back_inserter(common));
  std::sort(apexes.begin(), apexes.end());
  if (common != apexes) return false;
  const auto is_ear = [this](Index side) {
    return Twin(Next(side)) == kNone && Twin(Prev(side)) == kNone;
  };
  const bool is_tetrahedron = beside.size() == 3 && beside_kept.size() == 3 && twin != kNone;
  return !is_tetrahedron && !is_ear(h) && (twin == kNone || !is_ear(twin));
}

/// Takes out the triangle at h and glues its two other sides.
void FlatMesh::CloseUp(Index h) {
  const Index right = Twin(Next(h)), left = Twin(Prev(h));
  RemoveFace(Face(h));
  Glue(right, left);
  for (const Index side : {right, left}) {
    if (side == kNone) continue;
    vertices_[Tail(side)].corner = Next(side);
    vertices_[Tip(side)].corner = Prev(side);
  }
}

bool FlatMesh::Collapse(Index h, bool to_tail, double least_height, const TooLong& too_long) {
  if (to_tail && Twin(h) != kNone) return Collapse(Twin(h), false, least_height, too_long);
  const Index corner = to_tail ? Prev(h) : Next(h), kept_corner = to_tail ? Next(h) : Prev(h);
  const Index gone = VertexAt(corner), kept = VertexAt(kept_corner), twin = Twin(h);
  if (!MayCollapse(h, gone, kept)) return false;
  // `gone` is no cone, and so its frame leads from one of its triangles to the others.
  const RigidMotion to_vertex = ToFace(corner).Inverse();
  const Placed kept_there = At(kept_corner);
  std::vector<std::pair<Index, Placed>> moved;
  for (const Index c : CornersAround(gone)) {
    if (Face(c) == Face(h) || (twin != kNone && Face(c) == Face(twin))) continue;
    const Placed placed = {kept, ToFace(c) * to_vertex * kept_there.to_face};
    const Point at = placed.to_face(vertices_[kept].point.at);
    const Point right = Position(Next(c)), left = Position(Prev(c));
    if (!IsFit(at, right, left, least_height)) return false;
    const Index r = VertexAt(Next(c)), l = VertexAt(Prev(c));
    if (IsCone(kept) && IsCone(r) && IsCone(l)) return false;
    if (too_long(kept, r, (right - at).norm()) || too_long(kept, l, (left - at).norm()))
      return false;
    moved.emplace_back(c, placed);
  }
  if (moved.empty()) return false;
  for (const auto& [c, placed] : moved) {
    corner_[c].vertex = placed.vertex;
    corner_[c].to_face = placed.to_face;
  }
  CloseUp(h);
  if (twin != kNone) CloseUp(twin);
  vertices_[gone].corner = kNone;
  vertices_[kept].corner = moved[0].first;
  --num_alive_;
  return true;
}

bool FlatMesh::PutAt(Index v, const FlatDomain::Arrival& arrival, double distance,
                     double least_height) {
  const std::vector<Index> around = CornersAround(v);
  for (const Index c : around) {
    const Point at = (ToFace(c) * arrival.back)(arrival.point.at);
    if (!IsFit(at, Position(Next(c)), Position(Prev(c)), least_height)) return false;
  }
  for (const Index c : around) corner_[c].to_face = ToFace(c) * arrival.back;
  vertices_[v].point = arrival.point;
  vertices_[v].distance = distance;
  return true;
}

bool FlatMesh::Move(Index v, const Point& target, double least_height) {
  if (vertices_[v].kind != Kind::kFree) return false;
  const auto arrival = domain_.Trace(vertices_[v].point, target);
  return arrival && PutAt(v, *arrival, 0, least_height);
}

bool FlatMesh::Slide(Index v, double distance, double least_height) {
  const Vertex& vertex = vertices_[v];
  if (vertex.kind != Kind::kOnBoundary) return false;
  const double whole = domain_.loops()[vertex.loop].length();
  const FlatDomain::Arrival arrival = domain_.AlongLoop(vertex.loop, vertex.distance, distance);
  return PutAt(v, arrival, distance - std::floor(distance / whole) * whole, least_height);
}

}  // namespace cirque
