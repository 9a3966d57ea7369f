#pragma once

#include <vector>

#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/math/triple_double.h"

namespace cirque {

/// The lengths of halfedges in all their digits: what FlipComplex has, rounded to a double, is not these.
struct LowerDigits {
  double middle = 0, low = 0;

  TripleDouble Below(double high) const { return {high, middle, low}; }
};

/// FlipComplex::Flip of h to a length with three times a double's digits, whose lower ones `lower` has,
/// of halfedges.
void FlipTriple(Index h, const TripleDouble& length, FlipComplex* complex,
                std::vector<LowerDigits>* lower);

/// A Euclidean metric whose lengths have three times a double's digits, while its edges are flipped. A vertex
/// that lies h off the side opposite it, of length 1, is in the lengths' digits below h^2: doubles no
/// longer have one that is 1e-8 away, nor a needle's that is 1e-16 wide.
class TripleFlipComplex {
 public:
  /// `lengths`: E.
  TripleFlipComplex(const Triangulation& triangulation, const std::vector<TripleDouble>& lengths);

  Index twin(Index h) const { return complex_.twin(h); }
  const FlipComplex& complex() const { return complex_; }  ///< lengths rounded to doubles

  /// The angle of the corner opposite h [rad].
  double Angle(Index h) const;

  /// Flips the edge of h as FlipComplex does, where its two faces, unfolded, are a strictly convex
  /// quadrilateral; false where they are not. @pre two different faces are beside it.
  bool Turn(Index h);

 private:
  TripleDouble Length(Index h) const;
  bool IsConvexAtTail(Index h) const;
  TripleDouble OtherDiagonal(Index h) const;

  FlipComplex complex_;
  std::vector<LowerDigits> lower_;  ///< of lengths, of halfedges
};

}  // namespace cirque
