#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/metrics/mapped_faces.h"

namespace cirque {

/// One number about a whole map. By default neither the scale and the place of surface and image
/// nor midpoint subdivision change it.
struct FigureSpec {
  std::string name;           ///< unique among the figures of all metrics
  std::string meaning;        ///< in a line: formula, unit
  int length_power = 0;       ///< it grows with this power of the surface's scale
  bool axis_aligned = false;  ///< turning the image changes it (by less than quarter turns)
};

/// What a metric finds.
struct Measurement {
  Eigen::VectorXd face_values;  ///< one for each of the M measurable faces; empty: none
  std::vector<double> figures;  ///< as the metric lists them
};

/// A way to say how far a map is from a good one. The registry's name is that of its face values.
struct DistortionMeasure {
  std::string group;  ///< "angles", "areas", "lengths" or "injectivity": the heading in reports
  std::string face_meaning = {};   ///< formula and unit of the face values; empty: it has none
  double least = 0, greatest = 1;  ///< the face values at the two ends of the colours
  std::vector<FigureSpec> figures = {};
  Measurement (*measure)(const MappedFaces& faces) = nullptr;
};

}  // namespace cirque
