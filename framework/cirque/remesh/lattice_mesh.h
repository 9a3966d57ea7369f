#pragma once

#include <array>
#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/lattice/flat_domain.h"
#include "cirque/lattice/lattice_map.h"
#include "cirque/remesh/flat_mesh.h"

namespace cirque {

/// The lattice as a mesh of a closed flat domain in cells: its vertices are the points of the lattice,
/// cones among them, all else is collapsed, and edges are turned until they are Delaunay: triangles of
/// the lattice, or halves of its squares. `domain` is DomainOf of the map's uv.
/// Error (kNotConverged): vertices remain or triangles are no cells, as where two cells would have
/// more than an edge in common; (kCancelled).
StatusOr<FlatMesh> MakeLatticeMesh(const FlatDomain& domain, LatticeKind kind,
                                   const LatticeMap& map, const SolveControl& control);

/// The squares of a mesh of their halves: four halfedges' tails each, as corners of the mesh,
/// counter-clockwise.
std::vector<std::array<Index, 4>> SquaresOf(const FlatMesh& mesh);

}  // namespace cirque
