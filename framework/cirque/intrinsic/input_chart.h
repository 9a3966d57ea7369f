#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"

namespace cirque {

/// A flat metric, solved on an intrinsic triangulation, as the triangles of the input have it when
/// their corners are joined by straight lines: the map that is linear on every input triangle.
/// Faces, corners and edges are those of the input.
struct InputChart {
  CornerAngles angles;         ///< 3F [rad]; of a flipped triangle negative, with sum -pi
  EdgeLengths lengths;         ///< E
  std::vector<Index> flipped;  ///< faces whose triangle is not positively oriented, increasing
};

/// Undoes the flips in reverse order with vectors instead of lengths: two faces are developed into
/// one frame, where the edge's other diagonal is a sum of two sides whether it lies inside their
/// quadrilateral or not. So the input's connectivity always comes back, at the price of triangles
/// that may be flipped. With v_h the vectors of the sides, of sum zero in every face, and g the
/// twin of h, whose face is turned by -v_h / v_g into the frame of the other, undoing the flip of h
/// makes
///   v_h = -(v_prev(g) + v_next(h)),
/// and the angle between sides a and b at a corner is atan2(a x b, a . b).
///
/// `flat_angles` (3F [rad]) and `flat_lengths` (E) are those of intrinsic.triangulation.
InputChart ReadOnInput(const Triangulation& input, const IntrinsicTriangulation& intrinsic,
                       const CornerAngles& flat_angles, const EdgeLengths& flat_lengths);

/// A flat metric brought back from an intrinsic triangulation towards the input's, as lengths that
/// triangles have: other than an InputChart it stops short where a triangle would be flipped.
struct FlippedBack {
  Triangulation triangulation;  ///< the input's arrays when no edge is stuck
  EdgeLengths lengths;          ///< of the flat metric
  std::vector<Index> stuck;     ///< its edges that are none of the input's, increasing
};

/// Undoes the flips of `intrinsic` in reverse order in another metric: `flat` gives that metric's
/// lengths for the edges of intrinsic.triangulation. A flip is not undone when its two faces,
/// unfolded, are not strictly convex or are not those that it left behind because a later flip was
/// not undone; such edges stay and are listed. (L. Kharevych's thesis announces this step.)
///
/// `flat`: E. What comes back is a triangulation of the same flat metric in every case, with the
/// input's own numbering where nothing is stuck.
FlippedBack FlipBack(const IntrinsicTriangulation& intrinsic, const EdgeLengths& flat);

}  // namespace cirque
