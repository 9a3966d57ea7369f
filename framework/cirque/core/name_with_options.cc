#include "cirque/core/name_with_options.h"

#include <sstream>

#include <fmt/format.h>

namespace cirque {

StatusOr<NameWithOptions> ParseNameWithOptions(const std::string& text) {
  const auto refuse = [&](const std::string& why) {
    return Status::InvalidInput(
        fmt::format("'{}': {}; expected NAME or NAME:KEY=VALUE,KEY=VALUE", text, why));
  };
  const std::size_t colon = text.find(':');
  NameWithOptions parsed = {text.substr(0, colon), {}};
  if (parsed.name.empty()) return refuse("the name is missing");
  if (colon == std::string::npos) return parsed;
  std::istringstream rest(text.substr(colon + 1));
  for (std::string item; std::getline(rest, item, ',');) {
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos || equals == 0) return refuse("'" + item + "' is no KEY=VALUE");
    const std::string key = item.substr(0, equals);
    if (!parsed.options.emplace(key, item.substr(equals + 1)).second) {
      return refuse("'" + key + "' is given twice");
    }
  }
  return parsed;
}

}  // namespace cirque
