#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/lattice/rigid_motion.h"

namespace cirque {

/// A point of a flat cone metric, in the frame of a face that has it.
struct FlatPoint {
  Index face = kNone;
  Eigen::Vector2d at = {0, 0};
};

/// A triangulated flat cone metric, every face with a frame of its own: no layout, and so no seams.
/// Interior vertices whose angles do not add up to 2 pi (kFlatAngle) are its cones.
class FlatDomain {
 public:
  static constexpr double kFlatAngle = 1e-6;  ///< [rad]

  /// @pre lengths that obey the triangle inequality, strictly.
  FlatDomain(Triangulation triangulation, const EdgeLengths& lengths);

  const Triangulation& triangulation() const { return triangulation_; }
  bool IsCone(Index v) const { return is_cone_[v]; }
  bool IsOnBoundary(Index v) const { return on_boundary_[v]; }
  double area() const { return area_; }

  /// Where a corner is in the frame of its face.
  const Eigen::Vector2d& Corner(Index corner) const { return corner_[corner]; }
  /// From the frame across an interior edge to that of the halfedge's own face.
  const RigidMotion& Across(Index h) const { return across_[h]; }
  /// In the point's face; may be negative by rounding.
  Eigen::Vector3d Barycentric(const FlatPoint& point) const;

  /// Where a way ended.
  struct Arrival {
    FlatPoint point;
    RigidMotion back;  ///< from the frame there to the frame where it began
  };

  /// The end of the straight way from a point to `target`, both in the frame of its face. From a
  /// vertex the faces around it are searched counter-clockwise, from the point's on. Nothing where
  /// the way leaves the domain. @pre it does not begin at a cone.
  std::optional<Arrival> Trace(const FlatPoint& from, const Eigen::Vector2d& target) const;

  /// A boundary loop, by the distance along it from its beginning, the surface on the left.
  struct Loop {
    std::vector<Index> halfedges;
    std::vector<double> begin;          ///< of every halfedge, and the length of the whole
    std::vector<RigidMotion> to_first;  ///< from the frame at a halfedge to that of the first
    double length() const { return begin.back(); }
  };
  const std::vector<Loop>& loops() const { return loops_; }
  /// The point at a distance along a loop, taken modulo its length.
  FlatPoint OnLoop(Index loop, double distance) const;
  /// From a place on a loop along it, either way.
  Arrival AlongLoop(Index loop, double from, double to) const;

 private:
  void PlaceCorners(const EdgeLengths& lengths);
  void FindKinds();
  void TraceLoops();
  std::size_t PieceAt(const Loop& loop, double distance) const;

  Triangulation triangulation_;
  std::vector<Eigen::Vector2d> corner_;
  std::vector<RigidMotion> across_;
  std::vector<bool> is_cone_, on_boundary_;
  std::vector<Loop> loops_;
  double area_ = 0;
};

/// The flat metric that a map is whose edges have the same length on either side of seams.
FlatDomain DomainOf(const Triangulation& triangulation, const CornerUv& uv);

/// Twice the signed area of a triangle.
inline double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace cirque
