#pragma once

#include <Eigen/Core>

#include "cirque/energy/energy.h"

namespace cirque {

/// A point with what the energy says of it.
struct EnergyPoint {
  Eigen::VectorXd x;
  double value = 0;
  Eigen::VectorXd gradient;

  double largest() const { return gradient.lpNorm<Eigen::Infinity>(); }
};

/// @pre x lies in the energy's domain.
EnergyPoint PointAt(const Energy& energy, Eigen::VectorXd x);

/// Whether Relax returned true, and expects what it promises: if so a value that is no higher and
/// the true gradient, else nothing changed. `after`: the point there.
bool ExpectSoundRelax(const Energy& energy, double share, const EnergyPoint& before,
                      EnergyPoint* after);

}  // namespace cirque
