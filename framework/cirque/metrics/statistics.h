#pragma once

#include <vector>

#include <Eigen/Core>

namespace cirque {

/// Statistics of per-face values; without any value they are NaN.
double Smallest(const Eigen::VectorXd& values);
double Largest(const Eigen::VectorXd& values);

/// sum A x, for areas A of total 1.
double AreaMean(const Eigen::VectorXd& area, const Eigen::VectorXd& values);

/// For each fraction, given in increasing order, the smallest value that at least so much of the
/// area does not exceed.
std::vector<double> AreaPercentiles(const Eigen::VectorXd& area, const Eigen::VectorXd& values,
                                    const std::vector<double>& fractions);

}  // namespace cirque
