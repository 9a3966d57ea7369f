#pragma once

#include <nlohmann/json.hpp>
#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/diagnostics.h"

namespace cirque {

/// The list `figures` of a config, which the schema has let pass, as the report reads it from
/// figures.json: a list of objects with `kind`, `title`, `scale`, and `x`, `y`, `by` as objects of
/// `name`, `pointer` (into a record) and `label`. Reported: a y that is missing, or given to a
/// histogram; the same figure twice.
nlohmann::json ReadFigures(const YAML::Node& list, Diagnostics* problems);

}  // namespace cirque
