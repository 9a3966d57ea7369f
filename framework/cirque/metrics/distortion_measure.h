#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/registry.h"
#include "cirque/metrics/mapped_faces.h"

namespace cirque {

/// A quality figure: one number about a whole map. By default neither the scale and the position of
/// surface and image nor midpoint subdivision change it.
struct FigureSpec {
  std::string name;           ///< unique among the figures of all distortion measures
  std::string meaning;        ///< in a line: formula, unit
  int length_power = 0;       ///< it grows with this power of the surface's scale
  bool axis_aligned = false;  ///< turning the image changes it (by less than quarter turns)
};

/// What a distortion measure finds.
struct Measurement {
  Eigen::VectorXd face_values;  ///< one for each of the M measurable faces; empty: none
  std::vector<double> figures;  ///< as DistortionMeasure::figures lists them
};

/// A way to say how far a map is from a good one. The registry's name is that of its face values.
struct DistortionMeasure {
  std::string group;  ///< "angles", "areas", "lengths" or "injectivity": the heading in reports
  std::string face_meaning = {};   ///< formula and unit of the face values; empty: it has none
  double least = 0, greatest = 1;  ///< the face values at the two ends of the colours
  std::vector<FigureSpec> figures = {};
  Measurement (*measure)(const MappedFaces& faces) = nullptr;
};

/// All distortion measures by name. A new one is a function declared in measures.h and a line in
/// registry.cc; reports, files of measures, `quantities` of experiments and the tests of
/// invariance find it there.
const Registry<DistortionMeasure>& DistortionMeasures();

/// Statistics of face values, M each; without any value they are NaN.
double Smallest(const Eigen::VectorXd& values);
double Largest(const Eigen::VectorXd& values);

/// sum A x, for areas A of total 1.
double AreaMean(const Eigen::VectorXd& area, const Eigen::VectorXd& values);

/// For each fraction, given in increasing order, the smallest value that at least so much of the
/// area does not exceed.
std::vector<double> AreaPercentiles(const Eigen::VectorXd& area, const Eigen::VectorXd& values,
                                    const std::vector<double>& fractions);

}  // namespace cirque
