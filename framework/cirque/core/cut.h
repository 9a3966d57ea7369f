#pragma once

#include <algorithm>
#include <vector>

#include "cirque/core/triangulation.h"

namespace cirque {

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

Patches ConnectedPatches(const Triangulation& triangulation);

}  // namespace cirque
