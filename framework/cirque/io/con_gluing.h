#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/types.h"

namespace cirque {

/// The faces that a CON file lists, before their gluing is known to be one.
struct ConFaces {
  Index num_vertices = 0;
  std::vector<Index> vertex;   ///< 3F, counted from 0
  std::vector<double> length;  ///< 3F
  std::vector<Index> twin;     ///< 3F, kNone on the boundary; empty: the file does not say
  std::vector<int> line;       ///< F: where each face stands in the file
};

/// Glues the faces of the file `path` by their vertices where it is silent (`twin` empty), and checks
/// the gluing against the invariants of Triangulation, the lengths of glued sides against each
/// other, and that the surface is a connected manifold. Errors are "path:line: ...", faces and
/// vertices counted from 1.
Status GlueFaces(const std::string& path, ConFaces* faces);

}  // namespace cirque
