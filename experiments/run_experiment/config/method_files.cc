#include "experiments/run_experiment/config/method_files.h"

#include <utility>

#include "cirque/core/option.h"

namespace cirque {
namespace {

struct NamedOption {
  const char* key;
  std::string ParameterizeOptions::*text;
};

constexpr NamedOption kNamed[] = {{"cones", &ParameterizeOptions::cones},
                                  {"boundary", &ParameterizeOptions::boundary}};

std::string ToText(const NameWithOptions& named) {
  std::string text = named.name;
  for (const auto& [key, value] : named.options) {
    text += (text.size() == named.name.size() ? ":" : ",") + key + "=" + value;
  }
  return text;
}

}  // namespace

Status ForEachFile(const TakeFile& take, ParameterizeOptions* options) {
  if (!options->edge_costs.empty()) {
    if (Status s = take("edge_costs", &options->edge_costs); !s.ok()) return s;
  }
  for (const auto& [key, member] : kNamed) {
    std::string& text = options->*member;
    StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
    if (!named.ok() || !named->options.contains("file")) continue;
    if (Status s = take(key, &named->options["file"]); !s.ok()) return s;
    text = ToText(*named);
  }
  return Status();
}

}  // namespace cirque
