#pragma once

#include <functional>

#include "cirque/core/status.h"
#include "cirque/pipeline/options.h"
#include "cirque/pipeline/parameterization.h"

namespace cirque {

/// Makes a map by options.
using MapByOptions = std::function<Status(const ParameterizeOptions&, Parameterization*)>;

/// `make` by these options; where their cut heuristic names candidates (CutHeuristic::Candidates), once
/// by each, and the map that covers the largest share of its bounding square is the result. Candidates
/// that lead to no map are passed over unless all do; the certificate counts those that led to one.
/// Errors: those of `make`.
Status MapFullest(const ParameterizeOptions& options, const MapByOptions& make,
                  Parameterization* result);

}  // namespace cirque
