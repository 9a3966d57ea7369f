#include "cirque/remesh/flat_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cirque {
namespace {

using Point = Eigen::Vector2d;

/// Height over longest side of the flattest triangles that are made: frames agree to less.
constexpr double kSliver = 1e-8;

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }
Index Face(Index h) { return Triangulation::Face(h); }

}  // namespace

FlatMesh::FlatMesh(const FlatDomain& domain, const std::vector<bool>& fixed) : domain_(domain) {
  const Triangulation& t = domain.triangulation();
  corner_.resize(t.vertex.size());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    corner_[h].vertex = t.vertex[h];
    corner_[h].twin = t.twin[h];
  }
  AddVertices(fixed);
  SplitFacesOfCones();
}

void FlatMesh::AddVertices(const std::vector<bool>& fixed) {
  const Triangulation& t = domain_.triangulation();
  vertices_.resize(t.num_vertices);
  num_alive_ = t.num_vertices;
  for (Index c = 0; c < t.num_halfedges(); ++c) vertices_[t.vertex[c]].corner = c;
  for (Index v = 0; v < t.num_vertices; ++v) {
    Vertex& vertex = vertices_[v];
    const std::vector<Index> around = CornersAround(v);
    vertex.point = {Face(around[0]), domain_.Corner(around[0])};
    if (domain_.IsCone(v)) vertex.kind = Kind::kCone;
    RigidMotion to_face;
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (i > 0) to_face = domain_.Across(Next(around[i - 1])).Inverse() * to_face;
      corner_[around[i]].to_face = to_face;
    }
  }
  const auto& loops = domain_.loops();
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l].halfedges.size(); ++i) {
      const Index v = t.Tail(loops[l].halfedges[i]);
      vertices_[v].kind = fixed[v] ? Kind::kFixedOnBoundary : Kind::kOnBoundary;
      vertices_[v].loop = static_cast<Index>(l);
      vertices_[v].distance = loops[l].begin[i];
    }
  }
}

void FlatMesh::SplitFacesOfCones() {
  const Index faces = domain_.triangulation().num_faces();
  for (Index f = 0; f < faces; ++f) {
    const Index c = 3 * f;
    if (!IsCone(VertexAt(c)) || !IsCone(VertexAt(c + 1)) || !IsCone(VertexAt(c + 2))) continue;
    const Point middle = (domain_.Corner(c) + domain_.Corner(c + 1) + domain_.Corner(c + 2)) / 3;
    InsertInside(f, {f, middle}, RigidMotion());
  }
}

RigidMotion FlatMesh::Across(Index h) const {
  const Index twin = Twin(h);
  if (!IsCone(Tail(h))) return ToFace(Next(h)) * ToFace(Prev(twin)).Inverse();
  if (!IsCone(Tip(h))) return ToFace(Prev(h)) * ToFace(Next(twin)).Inverse();
  return RigidMotion::Aligning(Position(Next(twin)), Position(Prev(twin)), Position(Prev(h)),
                               Position(Next(h)));
}

std::vector<Index> FlatMesh::CornersAround(Index v) const {
  const Index given = vertices_[v].corner;
  Index first = given;
  for (Index across = Twin(Prev(first)); across != kNone; across = Twin(Prev(first))) {
    first = Prev(across);
    if (first == given) break;
  }
  std::vector<Index> around;
  Index c = first;
  do {
    around.push_back(c);
    const Index across = Twin(Next(c));
    c = across == kNone ? kNone : Next(across);
  } while (c != kNone && c != first);
  return around;
}

std::vector<Index> FlatMesh::Neighbours(Index v) const {
  std::vector<Index> beside;
  const std::vector<Index> around = CornersAround(v);
  for (const Index c : around) beside.push_back(VertexAt(Next(c)));
  if (Twin(Next(around.back())) == kNone) beside.push_back(VertexAt(Prev(around.back())));
  return beside;
}

bool FlatMesh::HasEdge(Index a, Index b) const {
  const std::vector<Index> beside = Neighbours(a);
  return std::find(beside.begin(), beside.end(), b) != beside.end();
}

Index FlatMesh::AddFace() {
  if (free_faces_.empty()) {
    corner_.resize(corner_.size() + 3);
    return num_halfedges() / 3 - 1;
  }
  const Index face = free_faces_.back();
  free_faces_.pop_back();
  return face;
}

void FlatMesh::RemoveFace(Index face) {
  for (Index c = 3 * face; c < 3 * face + 3; ++c) corner_[c] = CornerData();
  free_faces_.push_back(face);
}

void FlatMesh::SetFace(Index face, const std::array<Placed, 3>& corners) {
  for (Index k = 0; k < 3; ++k) {
    corner_[3 * face + k].vertex = corners[k].vertex;
    corner_[3 * face + k].to_face = corners[k].to_face;
    vertices_[corners[k].vertex].corner = 3 * face + k;
  }
}

void FlatMesh::Glue(Index a, Index b) {
  if (a != kNone) corner_[a].twin = b;
  if (b != kNone) corner_[b].twin = a;
}

void FlatMesh::MoveRim(const std::vector<Index>& from, const std::vector<Index>& to) {
  std::vector<Index> twins;
  for (const Index h : from) {
    const auto own = std::find(from.begin(), from.end(), Twin(h));
    twins.push_back(own == from.end() ? Twin(h) : to[own - from.begin()]);
  }
  for (std::size_t i = 0; i < to.size(); ++i) Glue(to[i], twins[i]);
}

bool FlatMesh::IsFit(const Point& a, const Point& b, const Point& c, double least_height) const {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return Cross(a, b, c) > least_height * longest;
}

bool FlatMesh::Flip(Index h) {
  const Index t = Twin(h), f = Face(h);
  if (t == kNone || Face(t) == f) return false;
  const Index g = Face(t);
  const RigidMotion across = Across(h);
  const Placed c = At(h), a = At(Next(h)), b = At(Prev(h)), d = Seen(across, t);
  const auto at = [this](const Placed& p) { return p.to_face(vertices_[p.vertex].point.at); };
  if (!IsFit(at(c), at(a), at(d), kSliver) || !IsFit(at(d), at(b), at(c), kSliver)) return false;
  if (c.vertex == d.vertex || HasEdge(c.vertex, d.vertex)) return false;
  if (IsCone(c.vertex) && IsCone(d.vertex) && (IsCone(a.vertex) || IsCone(b.vertex))) return false;
  MoveRim({Next(t), Prev(h), Next(h), Prev(t)}, {3 * f, 3 * f + 2, 3 * g, 3 * g + 2});
  SetFace(f, {c, a, d});
  SetFace(g, {d, b, c});
  Glue(3 * f + 1, 3 * g + 1);
  return true;
}

std::optional<FlatDomain::Arrival> FlatMesh::TraceIn(Index face, const Point& target,
                                                     Index* from) const {
  for (Index c = 3 * face; c < 3 * face + 3; ++c) {
    if (IsCone(VertexAt(c))) continue;
    auto arrival = domain_.Trace(vertices_[VertexAt(c)].point, ToFace(c).Inverse()(target));
    if (!arrival) continue;
    *from = c;
    return arrival;
  }
  return std::nullopt;
}

Index FlatMesh::Split(Index h) { return Twin(h) == kNone ? SplitBoundary(h) : SplitInside(h); }

Index FlatMesh::SplitInside(Index h) {
  if (Face(h) == Face(Twin(h))) return kNone;
  const Point middle = (Position(Next(h)) + Position(Prev(h))) / 2;
  Index from = kNone;
  const auto arrival = TraceIn(Face(h), middle, &from);
  return arrival ? SplitAt(h, arrival->point, ToFace(from) * arrival->back) : kNone;
}

Index FlatMesh::SplitAt(Index h, const FlatPoint& point, const RigidMotion& to_face) {
  const Index t = Twin(h), f = Face(h), g = Face(t), v = num_vertices();
  const Placed m = {v, to_face}, m_in_g = {v, Across(t) * to_face};
  const Placed c = At(h), a = At(Next(h)), b = At(Prev(h));
  const Placed d = At(t), b_in_g = At(Next(t)), a_in_g = At(Prev(t));
  vertices_.push_back({point});
  ++num_alive_;
  const Index f2 = AddFace(), g2 = AddFace();
  MoveRim({Next(h), Prev(h), Next(t), Prev(t)}, {3 * f2 + 1, 3 * f + 2, 3 * g2 + 1, 3 * g + 2});
  SetFace(f, {c, a, m});
  SetFace(f2, {c, m, b});
  SetFace(g, {d, b_in_g, m_in_g});
  SetFace(g2, {d, m_in_g, a_in_g});
  Glue(3 * f + 1, 3 * f2 + 2);
  Glue(3 * g + 1, 3 * g2 + 2);
  Glue(3 * f, 3 * g2);
  Glue(3 * f2, 3 * g);
  return v;
}

Index FlatMesh::SplitBoundary(Index h) {
  const Index f = Face(h);
  const Vertex &tail = vertices_[Tail(h)], &tip = vertices_[Tip(h)];
  const double whole = domain_.loops()[tail.loop].length();
  const double ahead = tip.distance > tail.distance ? tip.distance - tail.distance
                                                    : tip.distance + whole - tail.distance;
  double distance = tail.distance + ahead / 2;
  const FlatDomain::Arrival arrival = domain_.AlongLoop(tail.loop, tail.distance, distance);
  if (distance >= whole) distance -= whole;
  const Index v = num_vertices();
  const Placed m = {v, ToFace(Next(h)) * arrival.back};
  const Point at = m.to_face(arrival.point.at);
  if (!IsFit(Position(h), Position(Next(h)), at, kSliver) ||
      !IsFit(Position(h), at, Position(Prev(h)), kSliver))
    return kNone;
  const Placed c = At(h), a = At(Next(h)), b = At(Prev(h));
  vertices_.push_back({arrival.point, Kind::kOnBoundary, tail.loop, distance, kNone});
  ++num_alive_;
  const Index f2 = AddFace();
  MoveRim({Next(h), Prev(h)}, {3 * f2 + 1, 3 * f + 2});
  SetFace(f, {c, a, m});
  SetFace(f2, {c, m, b});
  Glue(3 * f + 1, 3 * f2 + 2);
  corner_[3 * f].twin = kNone;
  corner_[3 * f2].twin = kNone;
  return v;
}

Index FlatMesh::InsertInside(Index f, const FlatPoint& point, const RigidMotion& to_face) {
  const Index v = num_vertices();
  const Placed a = At(3 * f), b = At(3 * f + 1), c = At(3 * f + 2), m = {v, to_face};
  vertices_.push_back({point});
  ++num_alive_;
  const Index f2 = AddFace(), f3 = AddFace();
  MoveRim({3 * f, 3 * f + 1, 3 * f + 2}, {3 * f2 + 2, 3 * f3 + 2, 3 * f + 2});
  SetFace(f, {a, b, m});
  SetFace(f2, {b, c, m});
  SetFace(f3, {c, a, m});
  Glue(3 * f, 3 * f2 + 1);
  Glue(3 * f2, 3 * f3 + 1);
  Glue(3 * f3, 3 * f + 1);
  return v;
}

Triangulation FlatMesh::MakeTriangulation(std::vector<Index>* kept) const {
  std::vector<Index> number(vertices_.size(), kNone), face_number(corner_.size() / 3, kNone);
  kept->clear();
  for (Index v = 0; v < num_vertices(); ++v) {
    if (vertices_[v].IsGone()) continue;
    number[v] = static_cast<Index>(kept->size());
    kept->push_back(v);
  }
  Index faces = 0;
  for (Index h = 0; h < num_halfedges(); h += 3) {
    if (!IsGone(h)) face_number[h / 3] = faces++;
  }
  std::vector<Index> vertex, twin;
  for (Index h = 0; h < num_halfedges(); ++h) {
    if (IsGone(h)) continue;
    vertex.push_back(number[VertexAt(h)]);
    twin.push_back(Twin(h) == kNone ? kNone : 3 * face_number[Face(Twin(h))] + Twin(h) % 3);
  }
  return NumberEdges(static_cast<Index>(kept->size()), std::move(vertex), std::move(twin));
}

}  // namespace cirque
