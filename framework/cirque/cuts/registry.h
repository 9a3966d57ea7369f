#pragma once

#include <functional>
#include <memory>
#include <string>

#include "cirque/core/option.h"
#include "cirque/core/option_factory.h"
#include "cirque/core/registry.h"
#include "cirque/cuts/cut_heuristic.h"

namespace cirque {

/// Makes a heuristic from its options; errors name the option, its value and its bound.
using CutHeuristicFactory =
    std::function<StatusOr<std::shared_ptr<const CutHeuristic>>(const OptionMap&)>;

/// The table of heuristics, one line an entry in registry.cc. Besides those of a file of their own:
///   flat_length  an edge's length in the flat metric: seams are short in the image
///   length       its length on the surface: the cut is short to the eye
///   fullest      that of all others whose map fills most of its bounding square
const Registry<CutHeuristicFactory>& CutHeuristics();

/// The heuristic of that name with those options. Errors (invalid input): an unknown name, with all
/// that are known; an option that is unknown or out of bounds. A program with a heuristic of its own
/// extends the table and hands it here:
///   MakeCutHeuristic("mine", options, CutHeuristics().With("mine", factory)).
StatusOr<std::shared_ptr<const CutHeuristic>> MakeCutHeuristic(
    const std::string& name, const OptionMap& options = {},
    const Registry<CutHeuristicFactory>& heuristics = CutHeuristics());

/// The heuristic that a text means, "visibility:directions=64". Errors (invalid input) as above, and
/// a text that is no name with options.
StatusOr<std::shared_ptr<const CutHeuristic>> ParseCutHeuristic(const std::string& text);

/// Whether the text is one, without looking at a surface.
Status CheckCutHeuristic(const std::string& text);

/// A factory of the heuristic H.
template <class H, class O>
CutHeuristicFactory CutFactory(const OptionTable<O>& table) {
  return FactoryOf<CutHeuristic, H>(table);
}

}  // namespace cirque
