#include "cirque/mesh/sub_triangulation.h"

#include <algorithm>
#include <utility>

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

std::vector<bool> LargestChordlessPiece(const Triangulation& disk) {
  const std::vector<bool> boundary = BoundaryVertices(disk);
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

}  // namespace cirque
