#pragma once

#include <functional>
#include <memory>
#include <string>

#include "cirque/cones/cone_heuristic.h"
#include "cirque/core/option_factory.h"
#include "cirque/core/registry.h"

namespace cirque {

/// Makes a heuristic from its options; errors name the option, its value and its bound.
using ConeHeuristicFactory =
    std::function<StatusOr<std::shared_ptr<const ConeHeuristic>>(const OptionMap&)>;

/// The table of heuristics, one line an entry in registry.cc. Besides those of a file of their own:
///   none   no cones at all: enough for a torus and for every surface with a boundary; on other
///          closed surfaces Gauss-Bonnet then refuses the targets
///   given  the cones of a file (io/cone_file.h), with their ranges; errors as of ReadConeFile
const Registry<ConeHeuristicFactory>& ConeHeuristics();

/// The heuristic of that name with those options. Errors (invalid input): an unknown name, with all
/// that are known; an option that is unknown or out of bounds. A program with a heuristic of its own
/// extends the table and hands it here:
///   MakeConeHeuristic("mine", options, ConeHeuristics().With("mine", factory)).
/// (`moving` starts from one of ConeHeuristics() whatever the table.)
StatusOr<std::shared_ptr<const ConeHeuristic>> MakeConeHeuristic(
    const std::string& name, const OptionMap& options = {},
    const Registry<ConeHeuristicFactory>& heuristics = ConeHeuristics());

/// The heuristic that a text means, "greedy:target=0.1", with `budget` as its option `cones` unless
/// that is -1. Errors (invalid input) as above, and a text that is no name with options.
StatusOr<std::shared_ptr<const ConeHeuristic>> ParseConeHeuristic(const std::string& text,
                                                                  int budget = -1);

/// Whether the text is one, without placing anything.
Status CheckConeHeuristic(const std::string& text);

/// A factory of the heuristic H.
template <class H, class O>
ConeHeuristicFactory HeuristicFactory(const OptionTable<O>& table) {
  return FactoryOf<ConeHeuristic, H>(table);
}

}  // namespace cirque
