#pragma once

#include <Eigen/Core>

namespace cirque {

// How points of the plane lie to each other, exactly: their doubles mean what they say.

/// Whether a comes before b from left to right and, of one x, from below.
bool LexicographicallyLess(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// Whether p lies strictly between a and b on their segment.
bool OnOpenSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// Whether a and b (both other than apex) lie on one ray from apex.
bool OnSameRay(const Eigen::Vector2d& apex, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// The part of a neighbourhood of `apex` swept counterclockwise from the ray towards `from` to the
/// ray towards `to`, without these rays. Equal rays mean the full turn, not the empty one.
struct Sector {
  Eigen::Vector2d apex, from, to;
};

/// Whether the ray from the sector's apex to p (other than the apex) runs inside the sector.
bool IsInSector(const Sector& sector, const Eigen::Vector2d& p);

}  // namespace cirque
