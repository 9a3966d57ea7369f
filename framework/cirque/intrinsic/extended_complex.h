#pragma once

#include <vector>

#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/math/double_double.h"

namespace cirque {

/// FlipComplex::Flip of h to a length with twice a double's digits, whose lower ones `low` has, of
/// halfedges.
void FlipExtended(Index h, const DoubleDouble& length, FlipComplex* complex,
                  std::vector<double>* low);

/// A Euclidean metric whose lengths have twice a double's digits, while its edges are flipped. A vertex
/// that lies h off the side opposite it, of length 1, is in the lengths' digits below h^2: doubles no
/// longer have one that is 1e-8 away, nor a needle's that is 1e-16 wide.
class ExtendedComplex {
 public:
  /// `lengths`: E.
  ExtendedComplex(const Triangulation& triangulation, const std::vector<DoubleDouble>& lengths);

  Index twin(Index h) const { return complex_.twin(h); }
  const FlipComplex& complex() const { return complex_; }  ///< lengths rounded to doubles

  /// The angle of the corner opposite h [rad].
  double Angle(Index h) const;

  /// Flips the edge of h as FlipComplex does, where its two faces, unfolded, are a strictly convex
  /// quadrilateral; false where they are not. @pre two different faces are beside it.
  bool Turn(Index h);

 private:
  DoubleDouble Length(Index h) const;
  bool IsConvexAtTail(Index h) const;
  DoubleDouble OtherDiagonal(Index h) const;

  FlipComplex complex_;
  std::vector<double> low_;  ///< lower digits of lengths, of halfedges
};

}  // namespace cirque
