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
/// the rest, whose straight boundary leaves them no area: such edges are split for the solve, and the
/// new vertices dropped. Where that leads to no map, those faces' boundary goes onto the arc, inner
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
///
/// The exact map is that of the first solve, before any edge was locked, placed and refined by
/// itself (DrawExactDisk). Nothing is spread out beside it, and where the map at the vertices flips
/// triangles they are where the exact one has them.
Status MapToDisk(const Surface& surface, const MapRequest& request, const SolveControl& control,
                 SurfaceMap* map);

/// The same solve, in the upper half-plane: the boundary on the real axis from 0 to 1, the pole,
/// which belongs at infinity, at a finite point high above (0.5 + i pole_height) from which its
/// faces are not flipped. Exact maps and errors as above; also kInvalidInput for faces beyond an edge
/// that joins two boundary vertices. Certificate: HalfPlaneSummary, flipped_triangles and the measures.
Status MapToHalfPlane(const Surface& surface, const MapRequest& request,
                      const SolveControl& control, SurfaceMap* map);

/// Maps the surface to the sphere by a circle pattern: intrinsic Delaunay flips on the closed
/// surface; the pole's star removed, its link free but convex (angle sums at most pi - epsilon, so
/// that the edges at the pole intersect properly too); coherent angles close to those of the
/// surface after an inversion of space about the pole; log radii; layout; stereographic projection;
/// the pole restored; Moebius normalisation. Input triangles that come out flipped on the sphere
/// get their edges locked and everything is solved again, at last on the input's connectivity.
/// Where a pole does not lead to a map, up to three others are tried unless the options name one.
///
/// kInvalidInput: no closed surface of genus 0, no such pole or normalisation; kInfeasible: no
/// coherent angles on the input's connectivity without the pole's star (the certificate holds the
/// proof; by Rivin's theorem no other vertex would do, save for the margin epsilon);
/// kUnrepresentable: limbs too long for doubles on one sphere, before any solve where the linear
/// model predicts it by far (PredictedLogRange); kNotConverged.
/// The exact map is that of a pole's first solve, before any edge was locked, normalised and refined by
/// itself (MakeExactOnSphere). Where the map at the vertices flips triangles, or there is none, they are
/// where the exact one has them.
/// Source of the reduction to the plane: L. Kharevych, thesis (2006), with the link kept convex.
Status MapToSphere(const Surface& surface, const MapRequest& request, const SolveControl& control,
                   SurfaceMap* map);

// Maps that are the plane's own, with the boundary's angle sums prescribed where the shape has
// corners and sides. Errors: those of Parameterize; kUnrepresentable also where triangles come out
// flipped once the sides are put in their place.

/// Map to a rectangle [0, m] x [0, 1] with the four corners given, the first at 0, the second at m;
/// m, the conformal modulus of the surface with these corners, is certificate value
/// conformal_modulus. Without corners: those of MapToPolygon. The sides are made exactly straight
/// and opposite ones exactly equal, by as much as opposite_side_mismatch says. kInvalidInput: no
/// topological disk, or corners that are not four different vertices of the boundary.
Status MapToRectangle(const Surface& surface, const MapRequest& request,
                      const SolveControl& control, SurfaceMap* map);

/// Map to a polygon of equal angles, the first side from (0, 0) to (1, 0). Corners, where none are
/// given, are what a map to the unit disk brings nearest to the corners of a regular polygon of
/// `sides` sides, so that the sides come out nearly equal (certificate: shortest_side,
/// longest_side); a boundary vertex with one triangle must be a corner and is taken first.
///
/// With targets in the request the boundary follows those angles instead: boundary vertices that
/// they leave free become straight (pi). Exterior angles pi - Theta_v must add up to 2 pi on a
/// disk.
///
/// kInvalidInput: no topological disk, fewer than three corners or more than the boundary has
/// vertices, corners that are no different vertices of the boundary. Certificate: PolygonSummary.
Status MapToPolygon(const Surface& surface, const MapRequest& request, const SolveControl& control,
                    SurfaceMap* map);

/// MapToPolygon with three corners: an equilateral triangle, which has no modulus.
Status MapToTriangle(const Surface& surface, const MapRequest& request, const SolveControl& control,
                     SurfaceMap* map);

// Periodic maps: the plane's own, with boundaries straight and no cones, whose seams then are
// translations. Seams are exact: the two places of a vertex on the cut differ by whole periods to the
// last bit. The exact map is placed likewise, by the periods of its own layout (ExactMapSummary), with
// those of crossings as exact; beside it the map at the vertices may flip triangles. Certificate:
// PeriodicSummary. Errors: kInvalidInput for any other topology, those of
// Parameterize, kUnrepresentable where triangles come out flipped at last.

/// Map of a surface of genus 0 with two boundary loops to the strip 0 <= y <= 1, periodic along x: the
/// longer loop at y = 0, the other one at y = 1, exactly. The period is 2 pi / log(R / r) of the annulus
/// that the surface is conformal to.
Status MapToStrip(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map);

/// The same strip wound round, z -> e^{2 pi i z / period}: the longer loop on the unit circle, the
/// other one on that of radius e^{-2 pi / period}, vertices on them to rounding; no seams. Triangles
/// are straight: of a mesh too coarse for the inner circle some come out flipped (kUnrepresentable).
Status MapToAnnulus(const Surface& surface, const MapRequest& request, const SolveControl& control,
                    SurfaceMap* map);

/// Map of a closed surface of genus 1 to the plane modulo 1 and tau, tau its modulus in the
/// fundamental domain (ReduceLattice): opened along a short cut, no cones.
Status MapToTorus(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map);

/// Map of a surface of genus 0 with two or more boundary loops to the unit disk with round holes (P.
/// Koebe, 1908: there is one, up to Moebius maps of the disk), the longest loop on the unit circle. Every
/// loop gets the angle sums of a polygon inscribed in a circle whose edges have the lengths of the
/// loop's (HalfCentralAngles), at first those on the surface, then those of the flat metric that comes
/// out, by Anderson's acceleration until they stay: a fixed point is inscribed exactly, and closes
/// around every hole. One solve a round, ten to twenty rounds. Edges between two vertices of the outer
/// loop are split for the solve.
///
/// Boundary vertices lie on their circles to rounding. The two degrees of freedom that Moebius maps
/// leave are where the boundary's lengths on the surface lead. Certificate: RoundHolesSummary. Errors:
/// kInvalidInput for any other topology and for an edge between two vertices of one hole; those of
/// Parameterize; kUnrepresentable where triangles are too large for their circle; kNotConverged.
///
/// For the exact map the iteration goes on by the lengths of what is solved first, before any edge is
/// locked; that is put on its circles, refined and drawn by itself, of the surface's own triangles where
/// flips made some of vertices of one hole alone.
Status MapToRoundHoles(const Surface& surface, const MapRequest& request,
                       const SolveControl& control, SurfaceMap* map);

/// Map of a topological disk onto what a closed curve bounds, boundary vertices on the curve, the vertex
/// angle_zero at its first point, else the one from which the free boundary turns most as the curve does.
/// The boundary gets the angle sums of a polygon inscribed in the curve (InscribedPolygons), at first
/// with the lengths of the free boundary, then with those that come out, until they stay
/// (BoundaryIteration): then the map is a circle pattern's, conformal, whose boundary is that polygon but
/// for a similarity. Then vertices next to the curve's corners go there, and the interior is refined.
/// Where the lengths do not settle or triangles would flip, the map, or that to the disk, is bent onto the
/// curve instead (MeetLandmarks). Of the three degrees of freedom that conformal maps of a disk have the
/// vertex at the first point takes one; two are where the boundary's lengths lead.
///
/// Edges between two boundary vertices are split for the solve. Certificate: CurveSummary. Errors:
/// kInvalidInput for no topological disk, a vertex inside, a curve that is none; those of Parameterize;
/// kUnrepresentable where the boundary has too few vertices for the curve or triangles are too large for
/// it; kNotConverged where it cannot be bent onto the curve.
///
/// The exact map is that of a fit of its own, by the lengths of what is solved first, from the same vertex
/// on; its layout is put onto the curve, bent where triangles of it would flip, refined and drawn.
Status MapToCurve(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map);

/// Parameterize: a surface of any topology, opened along a cut where it is no disk or has cones.
Status MapToPlane(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map);

}  // namespace cirque
