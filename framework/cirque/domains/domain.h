#pragma once

#include <string>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/options.h"
#include "cirque/pipeline/parameterize.h"

namespace cirque {

/// What a map onto a chosen shape is to look like. Vertices are the surface's; kNone: chosen. Each
/// shape reads its own fields.
struct DomainOptions {
  Index centre = kNone;      ///< disk: inner vertex that goes to 0
  Index angle_zero = kNone;  ///< disk: boundary vertex that goes to (1, 0)
  /// disk, half-plane: the boundary vertex that the solve sends to infinity
  Index pole = kNone;
  /// disk, instead of a centre: "boundary" or "area" puts a centre of mass at 0 (MapToDisk)
  std::string normalization = "none";
  /// rectangle, polygon: corner vertices in the boundary's order, the surface on its left
  std::vector<Index> corners;
  int sides = 4;  ///< polygon without corners given: how many
};

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
Status MapToDisk(const Surface& surface, const DomainOptions& domain,
                 const ParameterizeOptions& options, const SolveControl& control,
                 Parameterization* result);

/// The same solve, in the upper half-plane: the boundary on the real axis from 0 to 1, the pole,
/// which belongs at infinity, at a finite point high above (0.5 + i pole_height) from which its
/// faces are not flipped. Errors as above; also kInvalidInput for faces beyond an edge that joins
/// two boundary vertices.
Status MapToHalfPlane(const Surface& surface, const DomainOptions& domain,
                      const ParameterizeOptions& options, const SolveControl& control,
                      Parameterization* result);

/// Map to a rectangle [0, m] x [0, 1] with the four corners given, the first at 0, the second at m;
/// m, the conformal modulus of the surface with these corners, is certificate value
/// conformal_modulus. Without corners: those of MapToPolygon.
Status MapToRectangle(const Surface& surface, const DomainOptions& domain,
                      const ParameterizeOptions& options, const SolveControl& control,
                      Parameterization* result);

/// Map to a polygon of equal angles, the first side from (0, 0) to (1, 0). Corners, where none are
/// given, are what a map to the unit disk brings nearest to the corners of a regular polygon of
/// `sides` sides, so that the sides come out nearly equal (certificate: shortest_side,
/// longest_side); a boundary vertex with one triangle must be a corner and is taken first.
/// Certificate: corner_vertex_0, ... as the input file numbers them.
Status MapToPolygon(const Surface& surface, const DomainOptions& domain,
                    const ParameterizeOptions& options, const SolveControl& control,
                    Parameterization* result);

/// Map with a boundary that follows given angles: boundary vertices that `targets` leaves free
/// become straight (pi). Exterior angles pi - Theta_v must add up to 2 pi on a disk.
Status MapToExteriorAngles(const Surface& surface, const ConeTargets& targets,
                           const ParameterizeOptions& options, const SolveControl& control,
                           Parameterization* result);

}  // namespace cirque
