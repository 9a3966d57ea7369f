#pragma once

#include <array>
#include <complex>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/types.h"
#include "cirque/mesh/coarsen.h"

namespace cirque {

/// A map to the plane of a surface some of whose edges are collapsed. Faces and halfedges
/// (Triangulation) are numbered as without collapses. On the two sides of a cut edge the images may
/// differ, by a similarity each.
struct CollapsedMap {
  std::vector<std::array<Index, 3>> corner;  ///< F: vertices, those of CollapseLog::corner
  std::vector<bool> there;                   ///< F: not collapsed
  std::vector<bool> cut;                     ///< 3F: halfedges on the cut, both of an edge
  CornerUv uv;                               ///< 3F, counter-clockwise in every face that is there
};

/// A frame of the plane in which a part of a star lies: its points are turn * z + shift for z in the
/// frame of the whole.
struct PlaneFrame {
  std::complex<double> turn = 1, shift = 0;
  bool own = true;  ///< the frame of the whole

  Eigen::Vector2d From(const Eigen::Vector2d& p) const;
  Eigen::Vector2d ToWhole(const Eigen::Vector2d& p) const;
  /// The frame across an edge from a to b, of which they are c and d.
  PlaneFrame Across(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                    const Eigen::Vector2d& d) const;
};

/// The star of the vertex that a log took away last: its ring in space and, unrolled across cut edges
/// within, in the plane, in the frame of the first face that is there.
class CollapsedStar {
 public:
  /// `map` must outlive the star. @pre the log is not empty.
  CollapsedStar(const std::vector<Eigen::Vector3d>& position, const CollapseLog& log,
                CollapsedMap* map);

  bool closed() const { return closed_; }  ///< the vertex is none of the boundary
  std::size_t NumFaces() const { return faces_.size(); }
  /// The neighbours counter-clockwise, of one on the boundary from side to side; in space from the
  /// vertex, and in the plane.
  const std::vector<Eigen::Vector3d>& around() const { return around_; }
  const std::vector<Eigen::Vector2d>& ring() const { return ring_; }
  std::size_t Next(std::size_t k) const { return k + 1 < ring_.size() ? k + 1 : 0; }
  /// Where the vertex is to which it was collapsed: one of the ring.
  const Eigen::Vector2d& kept() const { return kept_at_; }

  /// Whether all triangles are counter-clockwise with the vertex there, exactly, each in its own
  /// frame.
  bool IsSeenFrom(const Eigen::Vector2d& at) const;

  /// The vertex is there again.
  void Place(const Eigen::Vector2d& at);

 private:
  struct Face {
    Index id;
    bool returns;                            ///< vanished by the collapse
    Index apex = 0;                          ///< the corner at the vertex that is to come back
    Eigen::Vector2d p = {0, 0}, q = {0, 0};  ///< the others, counter-clockwise
    Index ring_vertex[2] = {0, 0};
    PlaneFrame frame = {};
    bool cut_before = false;  ///< the edge to the face before is cut
  };

  Index CornerAt(Index face, Index vertex) const;
  const Eigen::Vector2d& KeptIn(const Face& face) const;
  void LayOutOthers();
  void LayOutReturning();
  void Unroll(const std::vector<Eigen::Vector3d>& position);
  void PlaceReturning(const Face& face, const Eigen::Vector2d& at, bool cut);

  CollapsedMap* map_;
  const Index removed_, kept_;
  std::vector<Face> faces_;
  bool closed_ = true;
  Eigen::Vector2d kept_at_ = {0, 0};
  std::vector<Eigen::Vector3d> around_;
  std::vector<Eigen::Vector2d> ring_;
};

}  // namespace cirque
