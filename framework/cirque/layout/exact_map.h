#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

struct Overlay;

/// A point of a triangulated surface.
struct SurfacePoint {
  Index face = kNone;
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();  ///< >= 0, sum 1; of corners 3 f + k
};

/// Barycentric coordinates of a point in a face that has it on its border or inside. @pre no face has
/// a vertex twice.
Eigen::Vector3d InFace(const Triangulation& triangulation, const SurfacePoint& point, Index face);

/// A map that is linear on the faces of a triangulation which the input was flipped to, on
/// triangles that each lie in one face of either: those of their overlay.
struct ExactMap {
  std::vector<SurfacePoint> point;    ///< on the input; first its vertices, then crossings; of
                                      ///< several surfaces those of one behind those of the other
  std::vector<Eigen::Vector2d> uv;    ///< a point on a seam has several
  std::vector<Index> corner;          ///< 3T: the point at every corner, counter-clockwise
  std::vector<Index> corner_uv;       ///< 3T
  std::vector<Index> face_of_input;   ///< T, increasing
  std::vector<Index> face_of_solved;  ///< T: of the other triangulation
  /// Of conformal equivalence, per point the logarithm of its weight in the projective map between
  /// the points (ideal_geodesic.h), the largest 0; empty: a circle pattern, linear.
  std::vector<double> log_weight = {};
  /// Per point, |x| = 1: a map to the unit sphere, which has neither uv nor corner_uv.
  std::vector<Eigen::Vector3d> position = {};

  Index num_triangles() const { return static_cast<Index>(face_of_input.size()); }
};

/// What was done against rounding.
struct ExactMapRepair {
  int edges_spread = 0;      ///< edges along which crossings were moved apart
  double largest_shift = 0;  ///< of a crossing, as a fraction of its edge
  /// Faces of the other triangulation with parts that doubles do not hold where they lie, increasing.
  std::vector<Index> too_small;
};

/// The exact map of `uv` (3F of `other`), which is continuous but along `cut`, on the input. Every
/// triangle is positively oriented, exactly so, in the plane and by the barycentric coordinates in
/// its face of the input. Where rounding would have it otherwise, in faces of few units in the last
/// place or where crossings lie close to each other, crossings along the edges of either
/// triangulation that it has sides on are moved apart, from 1e-10 up to all the way to where they
/// are evenly spaced; on both sides of an edge alike, so that no gap opens.
///
/// With a `grid` crossings lie on the cut's edges at multiples of 2^grid from their tails: where the
/// two sides of the cut are on that grid and differ by a translation, exactly, so do they.
///
/// Error (kUnrepresentable): evenly spaced ones do not do either, the face is too small for
/// doubles. @pre no face of `uv` is flipped.
StatusOr<ExactMap> MakeExactMap(const Triangulation& input, const Triangulation& other,
                                const Cut& cut, const CornerUv& uv, Overlay overlay,
                                ExactMapRepair* repair, std::optional<int> grid = {});

/// The same on the unit sphere, where the vertices lie at `position`: a crossing lies on the chord of
/// its edge in proportion, scaled to length 1, and every triangle is positively oriented as seen from
/// outside, exactly so. @pre no face of `other` is flipped there (FlippedSphericalFaces).
StatusOr<ExactMap> MakeExactSphereMap(const Triangulation& input, const Triangulation& other,
                                      const std::vector<Eigen::Vector3d>& position, Overlay overlay,
                                      ExactMapRepair* repair);

}  // namespace cirque
