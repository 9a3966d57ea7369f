#include "experiments/run_experiment/config/matrix.h"

namespace cirque {
namespace {

std::vector<std::string> ValuesOf(const YAML::Node& value) {
  if (value.IsScalar()) return {value.Scalar()};
  std::vector<std::string> values;
  for (const YAML::Node& item : value) values.push_back(item.Scalar());
  return values;
}

}  // namespace

std::vector<Axis> AxesOf(const YAML::Node& entry, const Schema& schema, const std::string& path) {
  std::vector<Axis> axes;
  for (const SchemaField* field : FieldsOf(schema, path)) {
    const YAML::Node value = entry[field->Key()];
    if (field->matrix && value) axes.push_back({field->Key(), ValuesOf(value)});
  }
  return axes;
}

double CountCombinations(const std::vector<Axis>& axes) {
  double count = 1;
  for (const Axis& axis : axes) count *= static_cast<double>(axis.values.size());
  return count;
}

std::vector<Combination> Combine(const std::vector<Axis>& axes) {
  std::vector<Combination> combinations = {{}};
  for (const Axis& axis : axes) {
    std::vector<Combination> longer;
    for (const Combination& combination : combinations) {
      for (const std::string& value : axis.values) {
        longer.push_back(combination);
        longer.back().settings.push_back({axis.key, value, axis.values.size() > 1});
      }
    }
    combinations = std::move(longer);
  }
  return combinations;
}

}  // namespace cirque
