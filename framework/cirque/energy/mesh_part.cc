#include "cirque/energy/mesh_part.h"

#include <cstddef>
#include <utility>

namespace cirque {
namespace {

/// The faces of each component by their distance from `root` or, elsewhere, from any face.
std::vector<Index> BreadthFirst(const Triangulation& t, Index root) {
  std::vector<Index> order;
  std::vector<bool> reached(t.num_faces(), false);
  order.reserve(t.num_faces());
  const auto reach = [&](Index f) {
    if (!reached[f]) order.push_back(f);
    reached[f] = true;
  };
  std::size_t next = 0;
  for (Index start = root, other = 0; other <= t.num_faces(); start = other++) {
    if (start < t.num_faces()) reach(start);
    for (; next < order.size(); ++next) {
      for (Index h = 3 * order[next]; h < 3 * order[next] + 3; ++h) {
        if (t.twin[h] != kNone) reach(Triangulation::Face(t.twin[h]));
      }
    }
  }
  return order;
}

/// Per face, in equal runs of an order that begins as far from somewhere as a face can be.
std::vector<int> ShareOut(const Triangulation& t, int num_ranks) {
  const std::vector<Index> order = BreadthFirst(t, BreadthFirst(t, 0).back());
  std::vector<int> owner(t.num_faces());
  for (std::size_t k = 0; k < order.size(); ++k) {
    owner[order[k]] = static_cast<int>(k * num_ranks / order.size());
  }
  return owner;
}

}  // namespace

void MeshPart::Send(Ranks* ranks, int to) const {
  ranks->SendArray(to, triangulation.vertex);
  ranks->SendArray(to, triangulation.twin);
  ranks->SendArray(to, std::vector<Index>{triangulation.num_vertices});
  for (const auto* numbers : {&number, &first}) ranks->SendArray(to, *numbers);
}

MeshPart MeshPart::Receive(Ranks* ranks) {
  MeshPart part;
  auto corners = ranks->ReceiveArray<Index>(0);
  auto twins = ranks->ReceiveArray<Index>(0);
  const Index num_vertices = ranks->ReceiveArray<Index>(0).front();
  for (auto* numbers : {&part.number, &part.first}) *numbers = ranks->ReceiveArray<int>(0);
  part.triangulation = NumberEdges(num_vertices, std::move(corners), std::move(twins));
  return part;
}

MeshPartition::MeshPartition(const Triangulation& t, std::vector<int> vertex_parameter,
                             int num_ranks)
    : t_(t),
      vertex_parameter_(std::move(vertex_parameter)),
      face_owner_(ShareOut(t, num_ranks)),
      face_number_(t.num_faces()),
      vertex_owner_(t.num_vertices, kNone),
      vertex_number_(vertex_parameter_.size(), kNone) {
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    int& owner = vertex_owner_[t.vertex[h]];
    if (owner == kNone) owner = OwnerOfFace(Triangulation::Face(h));
  }
  std::vector<int> counts(num_ranks, 0);
  for (const int owner : face_owner_) ++counts[owner];
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (HasParameter(v)) ++counts[vertex_owner_[v]];
  }
  first_.assign(1, 0);
  for (const int count : counts) first_.push_back(first_.back() + count);
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (Index f = 0; f < t.num_faces(); ++f) face_number_[f] = next[face_owner_[f]]++;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (HasParameter(v)) vertex_number_[v] = next[vertex_owner_[v]]++;
  }
}

/// Its own, those around its vertices, and all across an edge of those.
std::vector<bool> MeshPartition::FacesOf(int rank) const {
  std::vector<bool> inner(t_.num_faces(), false);
  for (Index h = 0; h < t_.num_halfedges(); ++h) {
    const Index v = t_.vertex[h], f = Triangulation::Face(h);
    const bool around = HasParameter(v) && vertex_owner_[v] == rank;
    if (around || OwnerOfFace(f) == rank) inner[f] = true;
  }
  std::vector<bool> faces = inner;
  for (Index h = 0; h < t_.num_halfedges(); ++h) {
    if (inner[Triangulation::Face(h)] && t_.twin[h] != kNone) {
      faces[Triangulation::Face(t_.twin[h])] = true;
    }
  }
  return faces;
}

void MeshPartition::TakeFaces(int rank, MeshPart* part) const {
  const std::vector<bool> chosen = FacesOf(rank);
  std::vector<Index> place(t_.num_faces(), kNone), vertex_place(t_.num_vertices, kNone);
  for (Index f = 0; f < t_.num_faces(); ++f) {
    if (!chosen[f]) continue;
    place[f] = static_cast<Index>(part->face.size());
    part->face.push_back(f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) vertex_place[t_.vertex[h]] = 0;
  }
  for (Index v = 0; v < t_.num_vertices; ++v) {
    if (vertex_place[v] == kNone) continue;
    vertex_place[v] = static_cast<Index>(part->vertex.size());
    part->vertex.push_back(v);
  }
  std::vector<Index> corners, twins;
  for (const Index f : part->face) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = t_.twin[h], across = g == kNone ? kNone : place[Triangulation::Face(g)];
      corners.push_back(vertex_place[t_.vertex[h]]);
      twins.push_back(across == kNone ? kNone : 3 * across + g % 3);
    }
  }
  part->triangulation =
      NumberEdges(static_cast<Index>(part->vertex.size()), std::move(corners), std::move(twins));
}

void MeshPartition::NumberParameters(MeshPart* part) const {
  part->first = first_;
  for (const Index f : part->face) {
    part->parameter.push_back(f);
    part->number.push_back(face_number_[f]);
  }
  for (const Index v : part->vertex) {
    if (!HasParameter(v)) continue;
    part->parameter.push_back(vertex_parameter_[v]);
    part->number.push_back(vertex_number_[v]);
  }
}

MeshPart MeshPartition::Part(int rank) const {
  MeshPart part;
  TakeFaces(rank, &part);
  NumberParameters(&part);
  return part;
}

}  // namespace cirque
