#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A short cut that opens a connected surface to one disk with all cones on its boundary: of any
/// genus, with any number of boundary loops, closed ones too. No branch of it ends anywhere but in
/// a cone or on the boundary. Empty for a disk without cones.
///
/// Handles: tree and cotree (J. Erickson, K. Whittlesey, "Greedy optimal homotopy and homology
/// generators", SODA 2005): a shortest-path tree, a maximum spanning tree of the dual by the length
/// of the loop that an edge closes, and the 2 g edges in neither with their paths to the root.
/// Loops and cones are then joined to that and to one another by a minimum spanning tree of
/// shortest paths between them (K. Mehlhorn, "A faster approximation algorithm for the Steiner
/// problem in graphs", 1988: at most twice the shortest tree). Boundary loops count as points, so
/// walking along them is free. O(E log E).
///
/// `edge_cost`: one an edge, >= 0 (edge lengths, for instance); infinity where an edge must stay
/// closed, as diagonals of polygons must. Those edges may separate no vertices, and cross the edges
/// of the dual along disks only. `cones`: vertices, in
/// any order, repeated or on the boundary too. Errors (invalid input): a cone that does not exist;
/// a sphere with fewer than two cones, which no cut through them opens.
StatusOr<Cut> CutGraph(const Triangulation& triangulation, const Eigen::VectorXd& edge_cost,
                       const std::vector<Index>& cones);

/// A given cut and what is needed beyond it: every patch that it leaves and that is no disk, or has
/// cones inside, is opened further by CutGraph. Errors: as of that; a surface in several pieces is
/// none.
StatusOr<Cut> CompleteCut(const Triangulation& triangulation, const Eigen::VectorXd& edge_cost,
                          const Cut& given, const std::vector<Index>& cones);

/// The interior vertices whose angle sum is not required to be 2 pi.
std::vector<Index> ConeVertices(const std::vector<bool>& boundary, const ConeTargets& targets);

/// Whether the surface can be laid out along the cut: every patch a disk, every cone on the
/// boundary of its patches. Errors (invalid input): all patches and cones concerned, numbered from
/// 0, and what to do.
Status CheckCut(const Triangulation& triangulation, const Cut& cut,
                const std::vector<Index>& cones);

}  // namespace cirque
