#include "experiments/run_experiment/config/entries.h"

#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/text.h"
#include "cirque/domains/domain.h"

#include "experiments/run_experiment/config/energy_methods.h"
#include "experiments/run_experiment/config/mesh_sources.h"
#include "experiments/run_experiment/config/method_files.h"
#include "experiments/run_experiment/config/quantities.h"
#include "experiments/run_experiment/config/schema.h"

namespace cirque {
namespace {

/// "cones, layout": the keys of methods that this domain reads and others do not.
std::string OwnKeys(const Domain& domain) {
  std::vector<std::string> keys;
  for (const std::string& option : ParameterizeOptionTable().Names()) {
    if (domain.Reads(option)) keys.push_back(option);
  }
  return keys.empty() ? "none of its like" : Join(keys);
}

void CheckDomain(const YAML::Node& entry, const std::string& name, Diagnostics* problems) {
  const Domain domain = *Domains().Find(name);
  for (const std::string& option : ParameterizeOptionTable().Names()) {
    const YAML::Node value = entry[option];
    if (!value || domain.Reads(option) || !IsReadBySomeDomain(option)) continue;
    problems->Add(PlaceOf(value), fmt::format("'{}' has no meaning with domain '{}', which takes "
                                              "{}; give that domain an entry of its own",
                                              option, name, OwnKeys(domain)));
  }
}

MethodSpec MakeMethod(const std::string& name, const Combination& combination) {
  MethodSpec method{name, {}};
  OptionMap given;
  for (const auto& [key, value, varies] : combination.settings) {
    if (key == "domain") {
      method.domain = value;
    } else if (key == "exact") {
      method.options.exact = value == "true";
    } else if (key == "energy") {
      method.trial.energy = value;
    } else if (key == "energy_solver") {
      method.trial.solver = value;
    } else if (key == "energy_start") {
      method.trial.start = value;
    } else {
      given[key] = value;
    }
    if (varies) method.name += fmt::format(",{}={}", key, value);
  }
  const Status status = ParameterizeOptionTable().Set(given, &method.options);
  CHECK(status.ok()) << status.message();  // the schema has let it pass
  return method;
}

/// Paths that the method names become absolute; a file that is not there is a problem.
void FindFiles(const YAML::Node& entry, const std::string& root, ParameterizeOptions* options,
               Diagnostics* problems) {
  const TakeFile find = [&](const std::string& key, std::string* path) {
    *path = AbsolutePath(root, *path);
    std::error_code error;
    if (!std::filesystem::is_regular_file(*path, error)) {
      problems->Add(PlaceOf(entry[key]), fmt::format("{}: there is no file '{}'", key, *path));
    }
    return Status();
  };
  const Status always = ForEachFile(find, options);
  CHECK(always.ok()) << always.message();
}

std::vector<std::string> ValuesOf(const YAML::Node& value) {
  std::vector<std::string> values;
  for (const YAML::Node& item : ItemsOf(value)) values.push_back(item.Scalar());
  return values;
}

nlohmann::json QuantityJson(const Quantity& quantity) {
  return {{"name", quantity.name}, {"pointer", quantity.pointer}, {"label", quantity.label}};
}

/// Whether the figure has the axes that its kind needs.
bool CheckAxes(const YAML::Node& entry, const std::string& kind, Diagnostics* problems) {
  const bool counts = kind == "histogram";
  if (counts && entry["y"]) {
    problems->Add(PlaceOf(entry["y"]), "a histogram counts runs: leave out 'y'");
  } else if (!counts && !entry["y"]) {
    problems->Add(PlaceOf(entry), fmt::format("'{}' needs 'y'; only a histogram has none", kind));
  }
  return counts != static_cast<bool>(entry["y"]);
}

std::string TitleOf(const YAML::Node& entry, const Quantity& x, const std::string& by) {
  const std::string what =
      entry["y"] ? FindQuantity(Quantities(), entry["y"].Scalar()).label + " against " : "";
  return fmt::format("{}{}, by {}", what, x.label, by);
}

nlohmann::json ReadFigure(const YAML::Node& entry, const std::string& kind) {
  const Quantity& x = FindQuantity(Quantities(), entry["x"].Scalar());
  const Quantity& by = FindQuantity(Groups(), TextOr(entry, "by", "method"));
  nlohmann::json figure = {{"kind", kind},
                           {"scale", TextOr(entry, "scale", "linear")},
                           {"title", TextOr(entry, "title", TitleOf(entry, x, by.label))},
                           {"x", QuantityJson(x)},
                           {"by", QuantityJson(by)}};
  if (entry["y"]) figure["y"] = QuantityJson(FindQuantity(Quantities(), entry["y"].Scalar()));
  return figure;
}

}  // namespace

std::vector<MethodSpec> ReadMethods(const YAML::Node& list, const std::string& root,
                                    Diagnostics* problems) {
  std::vector<MethodSpec> methods;
  std::map<std::string, Place> first_of_name;
  for (const YAML::Node& entry : list) {
    const YAML::Node name = entry["name"];
    const auto [first, is_new] = first_of_name.emplace(name.Scalar(), PlaceOf(name));
    if (!is_new) {
      problems->Add(PlaceOf(name), fmt::format("two methods are named '{}' (first on line {})",
                                               name.Scalar(), first->second.line));
    }
    CheckEnergyEntry(entry, problems);
    const std::vector<Axis> axes = AxesOf(entry, ConfigSchema(), "methods");
    for (const Axis& axis : axes) {
      if (axis.key != "domain") continue;
      for (const std::string& domain : axis.values) CheckDomain(entry, domain, problems);
    }
    for (const Combination& combination : Combine(axes)) {
      methods.push_back(MakeMethod(name.Scalar(), combination));
      FindFiles(entry, root, &methods.back().options, problems);
      const Status status = CheckOptions(methods.back().options);
      if (!status.ok()) problems->Add(PlaceOf(entry), status.message());
    }
  }
  return methods;
}

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

nlohmann::json ReadFigures(const YAML::Node& list, Diagnostics* problems) {
  nlohmann::json figures = nlohmann::json::array();
  std::set<nlohmann::json> seen;
  if (!list) return figures;
  for (const YAML::Node& entry : list) {
    const std::string kind = TextOr(entry, "kind", "scatter");
    if (!CheckAxes(entry, kind, problems)) continue;
    figures.push_back(ReadFigure(entry, kind));
    if (!seen.insert(figures.back()).second) {
      problems->Add(PlaceOf(entry), "this figure is listed twice");
    }
  }
  return figures;
}

}  // namespace cirque
