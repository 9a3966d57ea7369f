#pragma once

#include <complex>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

/// Flat layouts of annuli and tori, opened along a cut, brought to where their seams are whole periods
/// to the last bit.
namespace cirque {

/// A strip of height 1 that is periodic along x.
struct Strip {
  std::vector<std::complex<double>> place;  ///< of corners
  double period = 0;
  double mismatch = 0;  ///< of seams, before they were exact
  int grid = 0;         ///< places on the cut are multiples of 2^grid
};

/// A vertex of the longer one of two boundary loops.
Index VertexOnLongerLoop(const Triangulation& triangulation, const EdgeLengths& lengths);

/// Turns and scales the layout of a surface of genus 0 with two straight boundary loops so that the one
/// through `bottom` runs along the x axis and the other one at height 1, and makes that and the period
/// exact.
Strip UnrollStrip(const Triangulation& triangulation, const CornerUv& uv, Index bottom);

/// The radius of the circle on which the top of the strip lies once it is wound round.
double InnerRadius(const Strip& strip);

/// Winds the strip round, z -> e^{2 pi i z / period}: corners, every vertex once, its boundary on the
/// circles.
std::vector<std::complex<double>> WindRound(const Triangulation& triangulation, const Strip& strip);

/// The plane modulo 1 and tau, which is in the fundamental domain.
struct UnrolledTorus {
  std::vector<std::complex<double>> place;  ///< of corners
  std::complex<double> tau = {};
  double mismatch = 0;  ///< of seams, before they were exact
  int grid = 0;         ///< places on the cut are multiples of 2^grid
};

/// The layout of a torus without cones, opened along `cut`; `angles` are flat. Error (kNotConverged):
/// its seams lead to no lattice whose cell is the image.
StatusOr<UnrolledTorus> UnrollTorus(const Triangulation& triangulation, const Cut& cut,
                                    const CornerAngles& angles, const CornerUv& uv);

}  // namespace cirque
