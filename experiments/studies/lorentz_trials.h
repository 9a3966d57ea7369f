#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace cirque {

/// How one method ended on one set of points.
struct LorentzTrial {
  int iterations = 0;
  double centre = 0;    ///< |centre of mass| of the points as the method leaves them
  std::string outcome;  ///< "converged", or why not
};

/// `count` points within about `scale` of one direction, all from the seed.
std::vector<Eigen::Vector3d> Crowd(int count, double scale, unsigned seed);

/// MinimizeLorentz.
LorentzTrial RecentredNewton(const std::vector<Eigen::Vector3d>& points);

/// The strategy `newton`, with its line search, on the energy in ball coordinates.
LorentzTrial NewtonInBall(const std::vector<Eigen::Vector3d>& points);

/// Full steps x - H^-1 g in ball coordinates, as in the thesis.
LorentzTrial FullNewtonInBall(const std::vector<Eigen::Vector3d>& points);

}  // namespace cirque
