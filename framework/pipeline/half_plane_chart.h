#pragma once

#include <functional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/math/moebius.h"
#include "cirque/mesh/sub_triangulation.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// A topological disk with the star of a boundary vertex, its pole, taken off.
struct PuncturedDisk {
  std::vector<bool> core;  ///< per face of the surface: on the solved side of every chord
  Index pole = kNone;      ///< vertex of the surface
  SubTriangulation
      rest;             ///< the core without the pole's faces; empty when the core is one triangle
  EdgeLengths lengths;  ///< of rest
  ConeTargets targets;  ///< of rest
  std::vector<Index> chain;  ///< vertices of rest along the straight boundary, the surface left
  std::vector<Index> loop;   ///< all boundary vertices of the surface from the pole on, likewise
  std::vector<double> arc;  ///< per entry of loop the boundary's length up to it, as a share of all
};

/// A conformal map of the disk but for its pole to the upper half-plane.
struct HalfPlaneChart {
  PuncturedDisk disk;
  /// Per vertex of the surface; of the core's boundary real; of the pole and of what the core lacks
  /// without meaning.
  std::vector<Complex> position;
  std::vector<double> chain_length;  ///< of the edges of disk.chain, however far they range
  double straightness = 0;           ///< HalfPlane
  bool increasing = true;
};

/// kInvalidInput, with what to do, unless the surface has Euler characteristic 1 and one loop.
Status CheckIsDisk(const Triangulation& triangulation);

/// The faces of the surface that come out flipped when the chart is used.
using FlipsOfChart = std::function<std::vector<Index>(const HalfPlaneChart&)>;

/// Solves for the chart (MapToDisk says how), with the edges of flipped triangles locked and again
/// while that helps, then on the input's connectivity. Without a pole given, boundary vertices with
/// the straightest surroundings are tried in turn where a solve ends infeasible; last, with angle
/// sums along the pole's link that are only bounded. Status ok even if
/// the last chart still has flips: *clean says. @pre CheckIsDisk is ok.
Status SolveHalfPlaneChart(const Surface& surface, Index pole, const ParameterizeOptions& options,
                           const SolveControl& control, const FlipsOfChart& flips,
                           Certificate* certificate, HalfPlaneChart* chart, bool* clean);

}  // namespace cirque
