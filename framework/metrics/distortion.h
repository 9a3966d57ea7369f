#pragma once

#include <Eigen/Dense>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// Per-face distortion of a piecewise linear map from a metric to the plane; F entries each.
struct FaceDistortion {
  Eigen::VectorXd
      quasi_conformal;  ///< ratio of the singular values, >= 1; infinite for a flat image
  Eigen::VectorXd log_area_ratio;  ///< log of image area over area, both normalised to total 1
  Eigen::VectorXd area;            ///< of the source, total 1
};

/// Area-weighted figures of a FaceDistortion.
struct DistortionSummary {
  double quasi_conformal_mean = 0, quasi_conformal_max = 0;
  double log_area_ratio_l2 = 0, log_area_ratio_min = 0, log_area_ratio_max = 0;
};

/// Measures the map that takes each Euclidean triangle with the given edge lengths to its uv
/// triangle. The singular values are |c| + |a| and |c| - |a|, c and a the conformal and
/// anticonformal part of its differential.
FaceDistortion MeasureDistortion(const Triangulation& triangulation, const EdgeLengths& lengths,
                                 const CornerUv& uv);

DistortionSummary Summarize(const FaceDistortion& distortion);

}  // namespace cirque
