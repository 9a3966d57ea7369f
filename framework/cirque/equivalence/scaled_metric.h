#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/conformal_equivalence_energy.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/math/triple_double.h"

namespace cirque {

using VertexScales = std::vector<TripleDouble>;  ///< V

/// A closed surface, or one with a boundary whose edges stay, and the angle sums asked for.
struct ScaleProblem {
  using Flips = ConformalEquivalenceEnergy::Flips;

  ScaleProblem(const Triangulation& triangulation, const EdgeLengths& lengths, ScaleTargets targets,
               Flips flips);

  bool IsClosed() const;

  /// Whose u is counted from the scales.
  ConformalEquivalenceEnergy EnergyFrom(const VertexScales& scales) const;

  const Flips flips;
  const IntrinsicTriangulation start;  ///< Delaunay, unless nothing is flipped
  const ScaleTargets targets;
  const Eigen::VectorXd log_lengths;  ///< of start
};

/// A metric scaled by exp(u), flat but for cones.
struct ScaledMetric {
  /// A triangulation that is Delaunay in the scaled metric, reached by flips from the surface's. The
  /// first `euclidean_flips` of them keep the surface's metric, those after are Ptolemy flips, and
  /// `lengths` are the unscaled ones of Ptolemy's theorem.
  IntrinsicTriangulation intrinsic;
  int euclidean_flips = 0;
  Eigen::VectorXd log_scale;                       ///< u, V
  CornerAngles angles;                             ///< of intrinsic, scaled [rad]
  Eigen::VectorXd log_lengths;                     ///< of intrinsic, scaled
  std::vector<TripleDouble> extended_log_lengths;  ///< the same, as they were solved
  double residual = kUnset;                        ///< max |angle sum - target| [rad]
};

/// What rounding of the logarithms of lengths may do to the flat metric.
struct ScaleRounding {
  double by_doubles = 0;      ///< [rad], to the angle sums: with a double's digits
  double beyond_digits = 0;   ///< [rad], likewise with those that lengths have, three times as many
  double longest_needle = 0;  ///< largest range of a face's sides' logarithms
};

/// Writes the metric of the scales on a triangulation flipped from the problem's start to where
/// it is Delaunay for them: that has as few flips as need be, and depends on nothing that a solve went
/// through. False: the flips came to no end; the result is what it was, but for its scales.
bool MeasureScaledMetric(const ScaleProblem& problem, const VertexScales& scales,
                         ScaledMetric* result, ScaleRounding* rounding);

}  // namespace cirque
