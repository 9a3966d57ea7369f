#pragma once

#include <utility>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/triangulation.h"
#include "cirque/core/types.h"
#include "cirque/math/moebius.h"

namespace cirque {

/// A flat disk with a straight piece of boundary, in the upper half-plane.
struct HalfPlane {
  std::vector<Complex> position;  ///< V; on the straight piece exactly real
  double straightness = 0;  ///< largest |y| on the straight piece before that, over its length
  bool increasing = false;  ///< whether the straight piece's vertices follow each other strictly
};

/// Moves a layout so that the chain of boundary vertices, the surface on its left, runs along the
/// real axis in its direction, from 0 to 1. @pre the chain's ends are apart.
HalfPlane MoveToHalfPlane(const Triangulation& triangulation, const CornerUv& layout,
                          const std::vector<Index>& chain);

/// Points of the upper half-plane, real ones on its boundary, and infinity if flagged, as a
/// surface's weighted vertices.
struct WeightedPoints {
  std::vector<ExtendedComplex> point;
  std::vector<double> weight;
};

/// The point c above the real axis whose Cayley map brings the points' centre of mass to 0: of real
/// points on the unit circle itself (the two-dimensional Lorentz energy), of others with their
/// mirror images on the sphere whose hemisphere the disk is the stereographic image of, as
///   (2 w, 1 - |w|^2) / (1 + |w|^2).
/// `start` is some point above the axis, best amid the points; it is also the result where half of
/// the weight or more sits in one point, which no map centres.
Complex BalancingPoint(const WeightedPoints& points, Complex start, const SolveControl& control);

/// |sum_i weight_i p_i| / sum_i weight_i for points w of the unit disk, p = 2 w / (1 + |w|^2),
/// which is w itself on the circle.
double CentreOfMass(const std::vector<Complex>& points, const std::vector<double>& weights);

/// Replaces NaNs by what the shares `arc` (increasing, from 0, below 1) give between the known
/// angles before and after them; the first angle is known, and beyond the last comes 2 pi.
void FillAngles(const std::vector<double>& arc, std::vector<double>* angles);

/// The value with half of the weight below it. @pre there is one, and weights are positive.
double WeightedMedian(std::vector<std::pair<double, double>> value_and_weight);

}  // namespace cirque
