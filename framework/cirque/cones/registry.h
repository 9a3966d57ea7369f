#pragma once

#include <functional>
#include <memory>
#include <string>

#include "cirque/cones/cone_heuristic.h"
#include "cirque/core/registry.h"

namespace cirque {

using ConeHeuristicFactory =
    std::function<StatusOr<std::shared_ptr<const ConeHeuristic>>(const OptionMap&)>;

/// The table of heuristics, one line an entry in registry.cc.
const Registry<ConeHeuristicFactory>& ConeHeuristics();

/// The heuristic of that name with those options; errors name the option, its value and its bound.
StatusOr<std::shared_ptr<const ConeHeuristic>> MakeConeHeuristic(const std::string& name,
                                                                 const OptionMap& options = {});

/// A factory whose heuristic H is constructed from its options struct O, read through `table`.
template <class H, class O>
ConeHeuristicFactory HeuristicFactory(const OptionTable<O>& table) {
  return [table](const OptionMap& map) -> StatusOr<std::shared_ptr<const ConeHeuristic>> {
    O options;
    if (Status status = table.Set(map, &options); !status.ok()) return status;
    return std::shared_ptr<const ConeHeuristic>(std::make_shared<H>(options));
  };
}

}  // namespace cirque
