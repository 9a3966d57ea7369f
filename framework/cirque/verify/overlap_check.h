#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "cirque/verify/uv_plane.h"

namespace cirque::verify {

/// A tree of bounding boxes over segments, each node split at the median of its longer side. Unlike
/// a uniform grid it does not care how the lengths are distributed: a conformal map's boundary
/// edges may differ by e^20.
class SegmentTree {
 public:
  struct Segment {
    Point tail, tip;
  };

  explicit SegmentTree(std::vector<Segment> segments);

  /// Calls visit(i, j), i < j, for every two segments whose bounding boxes touch, in an order that
  /// depends on the segments only, until it returns false. O(n log n + pairs) on curves.
  void VisitTouchingBoxes(const std::function<bool(int, int)>& visit) const;

 private:
  struct Node {
    Eigen::AlignedBox2d box;
    int begin = 0, end = 0;  ///< of order_
    int right = 0;           ///< the left child follows its parent; 0 marks a leaf
  };

  int Build(int begin, int end);
  bool VisitWithin(int node, const std::function<bool(int, int)>& visit) const;
  bool VisitBetween(int a, int b, const std::function<bool(int, int)>& visit) const;
  bool VisitPair(int i, int j, const std::function<bool(int, int)>& visit) const;

  std::vector<Segment> segments_;
  std::vector<Eigen::AlignedBox2d> boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

/// How the UV boundary (the mesh's boundary and both sides of every seam) lies on itself. Touching
/// is allowed: only what makes two open pieces of the map cover the same points is listed.
struct OverlapResult {
  Index num_boundary_edges = 0;
  Index num_boundary_loops = 0;
  Index num_crossings = 0;  ///< pairs of boundary edges; counted up to kMaxCrossings
  std::pair<Index, Index> first_crossing = {kNone, kNone};  ///< smallest pair of halfedges found
  std::vector<Index> wrapped_boundary;  ///< vertices with a boundary corner of more than 2 pi
  std::pair<Index, Index> nested_patches = {kNone, kNone};  ///< (outer, inner), the first such

  static constexpr Index kMaxCrossings = 1000;

  bool overlaps() const {
    return num_crossings > 0 || !wrapped_boundary.empty() || nested_patches.first != kNone;
  }
};

/// Decides exactly whether a map is injective inside its patches. It must be locally injective:
/// every triangle counterclockwise, the triangles round every inner vertex turning once.
///
/// Why the boundary decides: push it inwards a little. Without crossings, and with the sectors at
/// every touching point disjoint, the pushed boundary of a patch consists of disjoint simple loops,
/// p of them counterclockwise, the rest of the b clockwise. Their tangents turn p - (b - p) times
/// in all, which is the Euler characteristic 2 - 2 g - b of the immersed patch, so p = 1 - g; some
/// loop runs counterclockwise round the patch's area, so g = 0 and p = 1. One counterclockwise loop
/// alone winds at most once about any point, and the winding number counts the preimages.
/// Patches with disjoint boundaries meet only when one lies inside the other, which is tested by
/// the winding number about the centroid of one of its triangles.
OverlapResult CheckOverlap(const UvComplex& complex);

}  // namespace cirque::verify
