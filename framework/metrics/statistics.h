#pragma once

#include <Eigen/Core>

namespace cirque {

/// Statistics of per-face values; without any value they are NaN.
double Smallest(const Eigen::VectorXd& values);
double Largest(const Eigen::VectorXd& values);

/// sum A x, for areas A of total 1.
double AreaMean(const Eigen::VectorXd& area, const Eigen::VectorXd& values);

/// The smallest value that at least this fraction of the area does not exceed.
double AreaPercentile(const Eigen::VectorXd& area, const Eigen::VectorXd& values, double fraction);

}  // namespace cirque
