#pragma once

#include <functional>
#include <memory>
#include <string>

#include <Eigen/Core>

#include "cirque/core/registry.h"
#include "cirque/core/status.h"
#include "cirque/energy/registry.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// A surface as the energies see it: flat targets where it can have them, its own angles as
/// reference, and the coherent angles of the quadratic fit. Energies made from `input` refer to it.
struct StudyProblem {
  std::string mesh;
  EnergyInput input;
};

/// kInfeasible or kNotConverged where there are no coherent angles. Vertices are flat; on a closed
/// surface that is no torus all of them share the curvature that Gauss-Bonnet asks for. `epsilon`:
/// margin of the angle fits [rad].
StatusOr<std::shared_ptr<const StudyProblem>> MakeProblem(const std::string& name,
                                                          const Surface& surface,
                                                          double epsilon = EnergyInput().epsilon);

/// Reads and checks the mesh. The problem is named as the file is.
StatusOr<std::shared_ptr<const StudyProblem>> LoadProblem(const std::string& path);

/// Where solves of the energy start: at zero, or where that lies outside the domain at the coherent
/// angles.
Eigen::VectorXd StartOf(const Energy& energy, const EnergyInput& input);

/// Where a solve of an energy begins.
using EnergyStart = std::function<Eigen::VectorXd(const Energy& energy, const EnergyInput& input,
                                                  const Eigen::VectorXd& minimizer)>;

/// own: as StartOf; solution: the minimiser itself; near: the minimiser moved in every parameter by up
/// to 0.1, by half of that and so on until it lies inside the domain, the same on every call.
const Registry<EnergyStart>& EnergyStarts();

/// What a minimiser is compared by, in radians or natural logarithms: the angles that multipliers
/// stand for, since the multipliers need not be unique; other parameters relative to the gauge's.
Eigen::VectorXd ComparableSolution(const Energy& energy, const Eigen::VectorXd& x);

}  // namespace cirque
