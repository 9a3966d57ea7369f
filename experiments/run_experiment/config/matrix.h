#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/schema.h"

namespace cirque {

/// One key of an entry with the values given for it.
struct Axis {
  std::string key;
  std::vector<std::string> values;
};

/// One choice of a value on every axis.
struct Combination {
  struct Setting {
    std::string key, value;
    bool varies = false;  ///< whether the axis has several values
  };
  std::vector<Setting> settings;
};

/// The given matrix keys of an entry, in the order of the schema.
std::vector<Axis> AxesOf(const YAML::Node& entry, const Schema& schema, const std::string& path);

/// How many combinations the axes have; a double, because it may exceed any integer.
double CountCombinations(const std::vector<Axis>& axes);

/// Their cross product, the last axis fastest.
std::vector<Combination> Combine(const std::vector<Axis>& axes);

}  // namespace cirque
