#pragma once

#include <algorithm>
#include <vector>

#include "cirque/core/types.h"

namespace cirque {

/// Connectivity of a triangulated, oriented surface: a Delta-complex, so a face may be glued to
/// itself and two vertices may share several edges. Halfedge h = 3 f + k is the edge of face f
/// opposite its corner k; it runs from the vertex of corner k + 1 to that of corner k + 2 (mod 3),
/// with the face on its left.
///
/// Invariants: twin[twin[h]] == h; twins run between the same two vertices in opposite directions;
/// edges are numbered by their smaller halfedge, in increasing order; every vertex is a corner of
/// some face.
struct Triangulation {
  Index num_vertices = 0;
  std::vector<Index> vertex;         ///< 3F: the vertex at corner h
  std::vector<Index> twin;           ///< 3F: the halfedge across the edge, kNone on the boundary
  std::vector<Index> edge;           ///< 3F: the edge of halfedge h
  std::vector<Index> edge_halfedge;  ///< E: the smaller halfedge of each edge

  Index num_faces() const { return static_cast<Index>(vertex.size() / 3); }
  Index num_halfedges() const { return static_cast<Index>(vertex.size()); }
  Index num_edges() const { return static_cast<Index>(edge_halfedge.size()); }

  static Index Face(Index h) { return h / 3; }
  static Index Next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index Prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  Index Tail(Index h) const { return vertex[Next(h)]; }
  Index Tip(Index h) const { return vertex[Prev(h)]; }
  bool IsBoundaryEdge(Index e) const { return twin[edge_halfedge[e]] == kNone; }

  /// Visits the corners at the vertex of `corner`, counter-clockwise from it; at a vertex on the
  /// boundary up to there, then clockwise the ones before it.
  template <class Visit>
  void ForEachCornerAround(Index corner, const Visit& visit) const {
    Index c = corner;
    do {
      visit(c);
      const Index across = twin[Next(c)];
      c = across == kNone ? kNone : Next(across);
    } while (c != kNone && c != corner);
    if (c == corner) return;
    for (Index across = twin[Prev(corner)]; across != kNone; across = twin[Prev(c)]) {
      c = Prev(across);
      visit(c);
    }
  }
};

/// Numbers the edges of a gluing that satisfies the invariants above.
Triangulation NumberEdges(Index num_vertices, std::vector<Index> vertex, std::vector<Index> twin);

/// For every vertex, whether it lies on the boundary.
std::vector<bool> BoundaryVertices(const Triangulation& triangulation);

/// For every vertex, its number of corners (of an interior vertex: its valence).
std::vector<Index> CornersPerVertex(const Triangulation& triangulation);

/// The boundary loops, each as its halfedges in order, the surface on the left. Loops start at
/// their smallest halfedge and are ordered by it.
std::vector<std::vector<Index>> BoundaryLoops(const Triangulation& triangulation);

/// V - E + F.
Index EulerCharacteristic(const Triangulation& triangulation);

/// The edges along which a surface is opened before it is laid out. What it says of boundary edges
/// has no meaning: they are open already.
struct Cut {
  std::vector<bool> edge;  ///< per edge of the Triangulation: opened

  /// Whether no edge is opened.
  bool IsEmpty() const { return std::find(edge.begin(), edge.end(), true) == edge.end(); }
};

/// The surface opened along the cut: a Triangulation with the same faces, corners and halfedges,
/// in which the halfedges of opened edges have no twin, hence with edges and vertices of its own. A
/// vertex of several fans of corners becomes several: the fan of its smallest corner keeps its
/// number, the others are numbered behind the vertices of `triangulation`. The result need not be
/// connected. Without a cut: `triangulation` itself. O(F).
/// @pre one flag an edge.
Triangulation CutOpen(const Triangulation& triangulation, const Cut& cut);

/// The connected pieces of a triangulation that is glued along its twins.
struct Patches {
  Index count = 0;
  std::vector<Index> of_face;  ///< numbered in the order of their first faces
};

/// Those of a triangulation. O(F).
Patches ConnectedPatches(const Triangulation& triangulation);

}  // namespace cirque
