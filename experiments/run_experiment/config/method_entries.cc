#include "experiments/run_experiment/config/method_entries.h"

#include <map>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/text.h"
#include "cirque/domains/domain.h"

#include "experiments/run_experiment/config/matrix.h"
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
  for (const auto& [key, value, varies] : combination.settings) {
    if (key == "domain") {
      method.domain = value;
    } else {
      const Status status = ParameterizeOptionTable().Set({{key, value}}, &method.options);
      CHECK(status.ok()) << status.message();  // the schema has let it pass
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
      const Status status = CheckOptions(methods.back().options);
      if (!status.ok()) problems->Add(PlaceOf(entry), status.message());
    }
  }
  return methods;
}

}  // namespace cirque
