#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cirque/angles/angle_fit.h"
#include "cirque/core/option_table.h"
#include "cirque/core/registry.h"

namespace cirque {

using AngleFitMethodFactory =
    std::function<StatusOr<std::shared_ptr<const AngleFitMethod>>(const OptionMap&)>;

/// The table of methods, one line an entry in registry.cc. `dual` takes the option `strategy` (a
/// name of SolverStrategies(), default the first) and hands its other options to that strategy.
const Registry<AngleFitMethodFactory>& AngleFitMethods();

/// What MakeAngleFitMethod takes: KnownStrategyNames(), then those of AngleFitMethods().
std::vector<std::string> AngleStrategyNames();

/// The method that users mean by `name`: a method of AngleFitMethods(), or the dual minimised with
/// that solver strategy. An unknown name is an error that lists all of them.
StatusOr<std::shared_ptr<const AngleFitMethod>> MakeAngleFitMethod(const std::string& name,
                                                                   const OptionMap& options = {});

}  // namespace cirque
