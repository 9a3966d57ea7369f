#pragma once

#include <optional>
#include <string>

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/config_text.h"

namespace cirque {

/// The one document of a text, or nothing after reporting why: it is no YAML, empty, or several
/// documents; or more than any config is: a megabyte, nested deeper than 20 levels, an alias inside
/// of what it stands for, or more than a million values when its aliases are written out. Takes time
/// and memory in proportion to the text.
std::optional<YAML::Node> ParseYaml(const std::string& text, Diagnostics* problems);

}  // namespace cirque
