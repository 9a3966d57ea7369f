#include "experiments/run_experiment/config/method_entries.h"

#include <map>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/text.h"
#include "cirque/domains/registry.h"

#include "experiments/run_experiment/config/matrix.h"
#include "experiments/run_experiment/config/method_fields.h"
#include "experiments/run_experiment/config/schema.h"

namespace cirque {
namespace {

const MethodField& FindMethodField(const std::string& name) {
  for (const MethodField& field : MethodFields()) {
    if (field.name == name) return field;
  }
  LOG(FATAL) << "no field of ParameterizeOptions is named " << name;
}

/// "cones, layout": the keys of methods that this domain reads and others do not.
std::string OwnKeys(const Domain& domain) {
  std::vector<std::string> keys;
  for (const MethodField& field : MethodFields()) {
    for (const std::string& read : domain.reads) {
      if (read == field.name) keys.push_back(read);
    }
  }
  return keys.empty() ? "none of its like" : Join(keys);
}

void CheckDomain(const YAML::Node& entry, const std::string& name, Diagnostics* problems) {
  const Domain domain = *Domains().Find(name);
  for (const MethodField& field : MethodFields()) {
    const YAML::Node value = entry[field.name];
    if (!value || domain.Reads(field.name) || !IsReadBySomeDomain(field.name)) continue;
    problems->Add(PlaceOf(value), fmt::format("'{}' has no meaning with domain '{}', which takes "
                                              "{}; give that domain an entry of its own",
                                              field.name, name, OwnKeys(domain)));
  }
}

MethodSpec MakeMethod(const std::string& name, const Combination& combination) {
  MethodSpec method{name, {}};
  for (const auto& [key, value, varies] : combination.settings) {
    if (key == "domain") {
      method.domain = value;
    } else {
      SetField(FindMethodField(key), value, &method.options);
    }
    if (varies) method.name += fmt::format(",{}={}", key, value);
  }
  return method;
}

}  // namespace

std::vector<MethodSpec> ReadMethods(const YAML::Node& list, Diagnostics* problems) {
  std::vector<MethodSpec> methods;
  std::map<std::string, Place> first_of_name;
  for (const YAML::Node& entry : list) {
    const YAML::Node name = entry["name"];
    const auto [first, is_new] = first_of_name.emplace(name.Scalar(), PlaceOf(name));
    if (!is_new) {
      problems->Add(PlaceOf(name), fmt::format("two methods are named '{}' (first on line {})",
                                               name.Scalar(), first->second.line));
    }
    const std::vector<Axis> axes = AxesOf(entry, ConfigSchema(), "methods");
    for (const Axis& axis : axes) {
      if (axis.key != "domain") continue;
      for (const std::string& domain : axis.values) CheckDomain(entry, domain, problems);
    }
    for (const Combination& combination : Combine(axes)) {
      methods.push_back(MakeMethod(name.Scalar(), combination));
    }
  }
  return methods;
}

}  // namespace cirque
