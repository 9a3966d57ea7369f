#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

/// A vertex of a boundary near a side of it that does not end there: the point
/// tail + along (tip - tail) of the side is the nearest.
struct Contact {
  Index vertex, tail, tip;
  double along;                ///< in [0, 1]
  std::complex<double> away;   ///< of absolute value 1, from that point to the vertex
  double distance, reach = 0;  ///< distance < reach
};

/// The boundary of an image that must not come to lie upon itself, as a descent sees it: a barrier
///   weight * sum over contacts (reach / distance - 1)^2,
/// infinite where the boundary touches itself, and the exact verdict. (J. Smith, S. Schaefer,
/// "Bijective parameterization with free boundaries", ACM TOG 34(4), 2015; there one reach holds for
/// all, here each side has its own, since scales of conformal maps differ by decades.)
struct Fence {
  struct Side {
    Index tail, tip;   ///< the image on its left; each vertex is a tail once
    double reach = 0;  ///< a contact's is the less of the side's and of that at its vertex
  };
  std::vector<Side> sides;
  double weight = 0;  ///< 0: no barrier

  /// Makes every side reach that share of its length.
  void SetReach(const Eigen::VectorXcd& z, double share);

  /// With everything's reach so many times as long.
  std::vector<Contact> Contacts(const Eigen::VectorXcd& z, double times = 1) const;

  /// Of the barrier; without one 0.
  double Value(const Eigen::VectorXcd& z) const;

  /// Whether the image covers a point twice, exactly (FindOverlap). @pre no triangle is flipped.
  bool IsCrossed(const Eigen::VectorXcd& z) const;
};

}  // namespace cirque
