#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/registry.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/energy.h"

namespace cirque {

/// What energies are made from; each takes what it needs. Must outlive the energy.
struct EnergyInput {
  Triangulation triangulation;
  CornerAngles reference =
      {};  ///< measured angles: of the angle fits' dual energies and of the barrier
  CoherentAngles coherent = {};  ///< of the circle-pattern energy
  ConeTargets targets = {};
  EdgeLengths lengths = {};                  ///< of the conformal-equivalence energies
  double epsilon = 1e-3;                     ///< margin of the angle fits [rad]
  std::vector<Eigen::Vector3d> points = {};  ///< unit vectors: of the Lorentz energy
  std::vector<double> weights = {};          ///< one per point
};

/// Makes an energy from what it takes of the input, which must outlive the energy.
using EnergyFactory = std::function<std::unique_ptr<Energy>(const EnergyInput&)>;

/// The table of energies, one line an entry in registry.cc. Every registered energy is audited.
const Registry<EnergyFactory>& Energies();

}  // namespace cirque
