#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/overlay.h"

namespace cirque {

/// Three triangulations with the same vertices, of which conformal equivalence flips one into the
/// other: an input, its Delaunay triangulation by flips in its own metric, and what Ptolemy flips and
/// scales made of that.
struct ScaledTriangulation {
  Triangulation input;
  IntrinsicTriangulation
      delaunay;                   ///< lengths: the surface's; flips: the first of those of `scaled`
  IntrinsicTriangulation scaled;  ///< lengths: scaled ones, by Ptolemy's theorem
  Eigen::VectorXd log_scale;      ///< V
};

/// The overlay of the input and what it was scaled and flipped to. Edges of the input are straight in
/// every face of the Delaunay triangulation, whose circumcircle is Klein's model of it, and edges of
/// the scaled one are ideal geodesics (ideal_geodesic.h), straight there too: so they meet where their
/// chords do in each face. What has been crossed to and fro, which no overlay of as few faces as can
/// be has, is left out; where rounding leaves other crossings than the flips' combinatorics has, the
/// input's edge is drawn as the ideal geodesic that it can be pulled to. Error: as MakeOverlay.
StatusOr<Overlay> OverlayThroughDelaunay(const ScaledTriangulation& triangulation,
                                         std::int64_t most_faces);

}  // namespace cirque
