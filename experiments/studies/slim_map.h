#pragma once

#include <complex>
#include <vector>

#include "cirque/mesh/surface.h"

namespace cirque {

/// A map of a disk to the plane, one point a vertex (PlacesOfVertices).
using VertexUv = std::vector<std::complex<double>>;

/// The area-weighted mean of (s^2 + t^2 + 1/s^2 + 1/t^2) / 2 - 2 over the faces, s and t the singular
/// values of the map, at the image's best scale; infinite where a face is flipped.
double SymmetricDirichletOf(const Surface& surface, const VertexUv& uv);

struct SlimMap {
  VertexUv uv;
  int steps = 0;
};

/// That energy's descent by another method than the framework's, to be compared with: scalable locally
/// injective mappings (M. Rabinovich, R. Poranne, D. Panozzo, O. Sorkine-Hornung, ACM TOG 36(2),
/// 2017). Every step fits Jacobians to the rotations nearest to them, with weights by which the
/// quadratic energy has the gradient of the true one, and goes as far along as flips no face and
/// lowers the energy enough. Ends after most_steps or where five on end lower it by less than
/// `least_gain`, relatively. @pre no face of `start` is flipped.
SlimMap MinimizeBySlim(const Surface& surface, VertexUv start, int most_steps, double least_gain);

}  // namespace cirque
