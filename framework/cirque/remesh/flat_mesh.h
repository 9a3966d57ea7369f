#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/triangulation.h"
#include "cirque/lattice/flat_domain.h"
#include "cirque/lattice/rigid_motion.h"

namespace cirque {

/// A triangulation of a flat cone metric whose vertices come, go and move. Its vertices are points of
/// the domain; its triangles are straight in the metric, each with a frame of its own, so that seams
/// are nowhere. Cones stay where they are; vertices on the boundary stay on it, and between them the
/// sides of triangles cut across its bends.
///
/// Halfedges and corners are numbered as in Triangulation; faces and vertices that are gone leave
/// gaps. No operation makes a face with a vertex twice, a second edge between two vertices, or a
/// face with three cones, whose frame nothing else would know; each returns whether it was done.
class FlatMesh {
 public:
  /// kFixed: a cone, or a vertex on the boundary that stays.
  enum class Kind { kFree, kOnBoundary, kFixedOnBoundary, kCone };

  struct Vertex {
    FlatPoint point;
    Kind kind = Kind::kFree;
    Index loop = kNone;    ///< on the boundary
    double distance = 0;   ///< along it
    Index corner = kNone;  ///< one of its corners; kNone: it is gone

    bool IsOnBoundary() const { return loop != kNone; }
    bool IsGone() const { return corner == kNone; }
  };

  /// The domain's own triangles, and a vertex in the middle of those that have three cones. `fixed`
  /// (V): vertices on the boundary that stay.
  FlatMesh(const FlatDomain& domain, const std::vector<bool>& fixed);

  const FlatDomain& domain() const { return domain_; }
  Index num_halfedges() const { return static_cast<Index>(corner_.size()); }
  Index num_vertices() const { return static_cast<Index>(vertices_.size()); }
  Index num_alive() const { return num_alive_; }
  const Vertex& vertex(Index v) const { return vertices_[v]; }

  bool IsGone(Index h) const { return corner_[h].vertex == kNone; }
  Index VertexAt(Index corner) const { return corner_[corner].vertex; }
  Index Twin(Index h) const { return corner_[h].twin; }
  Index Tail(Index h) const { return VertexAt(Triangulation::Next(h)); }
  Index Tip(Index h) const { return VertexAt(Triangulation::Prev(h)); }

  /// Where a corner is in the frame of its face.
  Eigen::Vector2d Position(Index corner) const {
    const CornerData& data = corner_[corner];
    return data.to_face(vertices_[data.vertex].point.at);
  }
  double Length(Index h) const {
    return (Position(Triangulation::Next(h)) - Position(Triangulation::Prev(h))).norm();
  }
  double TwiceArea(Index face) const {
    return Cross(Position(3 * face), Position(3 * face + 1), Position(3 * face + 2));
  }
  /// From the frame of a vertex to that of the face of one of its corners.
  const RigidMotion& ToFace(Index corner) const { return corner_[corner].to_face; }
  /// From the frame across an interior edge to that of the halfedge's face.
  RigidMotion Across(Index h) const;

  /// The corners at a vertex, counter-clockwise; at one on the boundary from the boundary on.
  std::vector<Index> CornersAround(Index v) const;
  /// The vertices beside it, likewise; at one on the boundary one more than corners.
  std::vector<Index> Neighbours(Index v) const;
  bool HasEdge(Index a, Index b) const;

  /// Turns an interior edge between two faces that are strictly convex together.
  bool Flip(Index h);
  /// A vertex in the middle of an edge; of a boundary edge, in the middle of its piece of boundary.
  /// kNone: not done.
  Index Split(Index h);
  /// A vertex on an inner edge, at a point whose place in the domain is known, with the motion to the
  /// frame of the halfedge's face.
  Index SplitAt(Index h, const FlatPoint& point, const RigidMotion& to_face);
  /// Moves the tail of an edge to its tip (or, `to_tail`, the tip to the tail), where it ends. All
  /// triangles that stay must have at least this part of their longest side as height, and no new
  /// side may be too long.
  using TooLong = std::function<bool(Index kept, Index other, double length)>;
  bool Collapse(Index h, bool to_tail, double least_height, const TooLong& too_long);
  /// Moves a free vertex straight to a point in its frame, where all of its triangles have at least
  /// this part of their longest side as height.
  bool Move(Index v, const Eigen::Vector2d& target, double least_height);
  /// Likewise a vertex of kind kOnBoundary to a distance along its loop.
  bool Slide(Index v, double distance, double least_height);

  /// A vertex inside a face, at a point in its frame, whose place in the domain is known.
  Index InsertInside(Index face, const FlatPoint& point, const RigidMotion& to_face);

  /// What is left, numbered without gaps: `kept` are its vertices.
  Triangulation MakeTriangulation(std::vector<Index>* kept) const;

 private:
  struct CornerData {
    Index vertex = kNone, twin = kNone;
    RigidMotion to_face;
  };
  /// A corner as it is put into a face.
  struct Placed {
    Index vertex;
    RigidMotion to_face;
  };

  void AddVertices(const std::vector<bool>& fixed);
  void SplitFacesOfCones();
  Placed At(Index corner) const { return {corner_[corner].vertex, corner_[corner].to_face}; }
  Placed Seen(const RigidMotion& across, Index corner) const {
    return {corner_[corner].vertex, across * corner_[corner].to_face};
  }
  Index AddFace();
  void RemoveFace(Index face);
  void SetFace(Index face, const std::array<Placed, 3>& corners);
  void Glue(Index a, Index b);
  /// Halfedges of the rim of what is replaced, by those that take their places.
  void MoveRim(const std::vector<Index>& from, const std::vector<Index>& to);
  bool IsCone(Index v) const { return vertices_[v].kind == Kind::kCone; }
  bool IsFit(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
             double least_height) const;
  std::optional<FlatDomain::Arrival> TraceIn(Index face, const Eigen::Vector2d& target,
                                             Index* from) const;
  Index SplitBoundary(Index h);
  Index SplitInside(Index h);
  bool MayCollapse(Index h, Index gone, Index kept) const;
  void CloseUp(Index h);
  bool PutAt(Index v, const FlatDomain::Arrival& arrival, double distance, double least_height);

  const FlatDomain& domain_;
  std::vector<CornerData> corner_;
  std::vector<Vertex> vertices_;
  std::vector<Index> free_faces_;
  Index num_alive_ = 0;
};

}  // namespace cirque
