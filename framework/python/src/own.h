#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "cirque/cones/cone_heuristic.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/energy/energy.h"

#include "run.h"

/// Python objects as what the library asks for. Exceptions that they raise end the run (Run::Call).
namespace cirque::python {

/// choose(problem) -> cones: (vertex, angle) or (vertex, least, greatest), angles in radians.
std::shared_ptr<const ConeHeuristic> HeuristicOf(py::object choose, Run* run);

/// distance(references, x) -> (value, slope, curvature), all arrays of one entry a corner: convex in
/// x, 0 at x = reference.
std::shared_ptr<const AngleObjective> ObjectiveOf(py::object distance, Run* run);

/// An object with
///   num_parameters               an int
///   evaluate(x)                  (value, gradient), or None outside the domain
///   hessian(x)                   (rows, columns, values): triplets, of which those of the lower
///                                triangle count; None outside the domain
///   is_convex, gauge_parameters  optional: True, []
std::shared_ptr<const Energy> EnergyOf(py::object energy, Run* run);

/// The classes that Python sees: ConeProblem and the library's energies.
void BindOwn(py::module_* module);

}  // namespace cirque::python
