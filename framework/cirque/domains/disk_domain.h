#pragma once

#include "cirque/domains/domain.h"

namespace cirque {

/// Conformal map of a topological disk to the unit disk: the star of a boundary vertex, the pole,
/// is taken off; the rest is solved with a straight boundary (angle sums pi) that turns along the
/// pole's link by the angles which the pole's own triangles give it, to at most pi / 2 at the
/// link's ends and pi between them, so that the faces at the pole are Delaunay in the surface and
/// its mirror image; a Moebius map takes the half-plane to the disk, infinity being where the pole
/// goes. Boundary vertices lie on the unit circle to rounding, the centre exactly at 0, the vertex
/// of angle zero exactly at (1, 0).
///
/// Without a centre given it is the inner vertex nearest to where `normalization` "area" would put
/// 0. "boundary": the boundary vertices, weighted by boundary length of the surface, have their
/// centre of mass at 0 (two-dimensional Lorentz energy). "area": so have all vertices, weighted by
/// area of the surface, on the hemisphere of which the disk is the stereographic image.
///
/// Faces beyond an edge that joins two boundary vertices (ears, for instance) cannot be solved with
/// the rest, whose straight boundary leaves them no area: their boundary goes onto the arc, inner
/// vertices to means of their neighbours. Input triangles that come out flipped get their edges
/// locked, then the input's connectivity is tried. Where even so the disk's coordinates do not tell
/// vertices apart (a corridor of length l and width w has an image of about e^{-pi l / w}), the
/// boundary is spread out by as little as helps, towards its arc length, and the interior follows
/// as a convex embedding, which is never flipped: certificate value boundary_spread in (0, 1], 0
/// for a conformal map.
///
/// Certificate: those of Flatten for the part that was solved; pole_vertex, centre_vertex and
/// angle_zero_vertex as the input file numbers them from 0; overhanging_faces, boundary_spread,
/// boundary_straightness, boundary_circle_error, centre_error, boundary_centre_of_mass,
/// area_centre_of_mass, flipped_triangles, and the measures of Parameterize, those of distortion
/// also as core_quasi_conformal_mean and _max for the faces that no chord cuts off (a triangle with
/// its corners on the circle is the flatter the smaller it is, whatever one does). Errors:
/// kInvalidInput for a surface that is no disk and for vertices that do not fit, and those of
/// Flatten: kInfeasible with a proof about the input's connectivity without the faces beyond chords
/// and those of the proof's removed vertex, a pole, the boundary straight but along the pole's
/// link, which is bounded only. `result` has no flat metric of the whole surface.
Status MapToDisk(const Surface& surface, const MapRequest& request, const SolveControl& control,
                 SurfaceMap* map);

/// The same solve, in the upper half-plane: the boundary on the real axis from 0 to 1, the pole,
/// which belongs at infinity, at a finite point high above (0.5 + i pole_height) from which its
/// faces are not flipped. Errors as above; also kInvalidInput for faces beyond an edge that joins
/// two boundary vertices. Certificate: HalfPlaneSummary, flipped_triangles and the measures.
Status MapToHalfPlane(const Surface& surface, const MapRequest& request,
                      const SolveControl& control, SurfaceMap* map);

}  // namespace cirque
