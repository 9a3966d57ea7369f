#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/punctured_disk.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/math/moebius.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/options.h"

namespace cirque {

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

/// A chart and what it was solved on.
struct SolvedChart {
  HalfPlaneChart chart;
  IntrinsicTriangulation
      rest;  ///< what chart.disk.rest was flipped to, with the disk's own lengths
  double layout_closure = 0;
};

/// What the whole disk, with these lengths, is flipped to where the rest of a chart is.
IntrinsicTriangulation FlippedWhole(const Triangulation& disk, const EdgeLengths& lengths,
                                    const SolvedChart& solved);

/// The boundary vertices of a disk that can be poles, those of the piece that has no chord
/// (LargestChordlessPiece), the best first: where the boundary is straight already, as are the
/// neighbours, and where the edges are Delaunay.
std::vector<Index> RankPoles(const IntrinsicSurface& disk);

/// kInvalidInput, with what to do, unless the surface has Euler characteristic 1 and one loop.
Status CheckIsDisk(const Triangulation& triangulation);

/// The faces of the surface that come out flipped when the chart is used.
using FlipsOfChart = std::function<std::vector<Index>(const HalfPlaneChart&)>;

/// What a chart is sought of.
struct ChartJob {
  const Surface& surface;
  const IntrinsicSurface& intrinsic;  ///< of the surface
  Index pole;                         ///< kNone: chosen
  const ParameterizeOptions& options;
  const SolveControl& control;
};

/// Solves for the chart (MapToDisk says how), with the edges of flipped triangles locked and again
/// while that helps, then on the input's connectivity. Without a pole given, boundary vertices with
/// the straightest surroundings are tried in turn where a solve ends infeasible; last, with angle
/// sums along the pole's link that are only bounded: a proof of infeasibility is about those, the
/// last pole being its removed vertex. Status ok even if the last chart still has flips: *clean
/// says. With ParameterizeOptions::exact, `first` is the chart that was solved first about the last
/// pole, before any edge was locked, as it was solved; none where the core is one triangle.
/// @pre CheckIsDisk is ok.
Status SolveHalfPlaneChart(const ChartJob& job, const FlipsOfChart& flips, Certificate* certificate,
                           HalfPlaneChart* chart, bool* clean, std::optional<SolvedChart>* first);

}  // namespace cirque
