#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cirque/angles/angle_fit.h"
#include "cirque/core/option_table.h"
#include "cirque/core/registry.h"

namespace cirque {

using AngleSolverFactory =
    std::function<StatusOr<std::shared_ptr<const AngleSolver>>(const OptionMap&)>;

/// The table of solvers, one line an entry in registry.cc. `dual` minimises the Lagrange dual of the
/// fit, which is convex and has no constraints; it takes every objective. Its option `strategy` is a
/// name of SolverStrategies(), default the first, and its other options are that strategy's. Ranged
/// angle sums make kinks, which the Newton strategies treat; kInvalidInput with the others.
const Registry<AngleSolverFactory>& AngleSolvers();

/// What MakeAngleSolver takes: KnownStrategyNames(), then those of AngleSolvers().
std::vector<std::string> AngleSolverNames();

/// The solver that users mean by NAME or NAME:KEY=VALUE,...: one of AngleSolvers(), or the dual
/// minimised with that solver strategy; `options` are those that the text does not give. Errors
/// (invalid input): an unknown name, with all that are known; an option that is unknown or out of
/// bounds.
StatusOr<std::shared_ptr<const AngleSolver>> MakeAngleSolver(const std::string& text,
                                                             const OptionMap& options = {});

/// Whether a config may say that (CheckSolverStrategy).
Status CheckAngleSolver(const std::string& text);

/// Whether by that text processes share the work (IsDistributedStrategy).
bool IsDistributedAngleSolver(const std::string& text);

}  // namespace cirque
