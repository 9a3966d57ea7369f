#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace cirque {

/// A directed edge with what it bounds on its left.
struct DirectedSegment {
  Eigen::Vector2d tail, tip;
};

/// Which contacts of segments a sweep lets pass beside that of two at a common end.
enum class Contacts {
  kTouching,  ///< all that do not make two left sides cover the same points
  kEndsOnly,  ///< none: the segments are a polygon's, and it must be simple
};

/// Decides exactly, in O(n log n) whatever the segments, whether what lies on the left of closed
/// curves covers every point at most once. No segment may have two equal ends. Returns two segments
/// that show that it does not: they cross, or lie one upon the other, or both have covered what is
/// between them; the first such in the order of the sweep.
///
/// A line moves over the plane from left to right (points on it from below, which is the same as a
/// line that leans a little) and keeps the segments that it meets from below upwards (M. Shamos,
/// D. Hoey, Geometric intersection problems, 1976). Going up the line, a segment that runs to the
/// right begins what is covered and one to the left ends it; so all is covered at most once exactly
/// where the two kinds alternate, the line over. Segments on one another have room for nothing
/// between them: there what ends comes before what begins. Two that cross are neighbours somewhere
/// before they do, and until then their order never changes, so it may be that of the segments.
std::optional<std::pair<int, int>> FindOverlap(const std::vector<DirectedSegment>& segments,
                                               Contacts contacts = Contacts::kTouching);

/// Whether the segments have a common point, exactly.
bool Intersect(const DirectedSegment& a, const DirectedSegment& b);

}  // namespace cirque
