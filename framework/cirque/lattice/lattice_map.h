#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/lattice/flat_domain.h"
#include "cirque/math/unit_lattice.h"

namespace cirque {

/// A map of a closed flat cone metric to the plane in units of a lattice: cones lie on its points, and
/// every seam's motion takes the lattice to itself.
struct LatticeMap {
  CornerUv uv;               ///< of the domain's corners
  double largest_shift = 0;  ///< that a corner was moved by, in cells
};

/// The metric laid out with cells of that size, then moved by the displacement of least Dirichlet
/// energy that brings cones and seams onto the lattice. The sides of the cut graph are lattice vectors
/// that close; displacements are complex linear in them, so that their energy is a Hermitian form, by
/// one factor of the Laplacian with the seams' rotations and one solve for each side; the lattice
/// vector near its minimum is found from its Cholesky factor, plane by plane (L. Babai, "On Lovasz'
/// lattice reduction and the nearest lattice point problem", 1986), for a number of directions of the
/// lattice, of which the least energy counts. The domain is opened along `cut`, which leaves a disk and
/// no cone inside; null: along a short one.
///
/// Errors: kInvalidInput, a boundary, or rotations along loops that are no multiples (1e-6 rad);
/// kNotConverged, triangles would be flipped, as where cones are closer to each other than a cell.
StatusOr<LatticeMap> MakeLatticeMap(const FlatDomain& domain, LatticeKind kind, double cell,
                                    const Cut* cut = nullptr);

}  // namespace cirque
