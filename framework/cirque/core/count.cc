#include "cirque/core/count.h"

#include <fmt/format.h>

namespace cirque {

std::string Count(std::size_t number, const std::string& singular) {
  if (number == 1) return fmt::format("1 {}", singular);
  if (singular.ends_with("vertex")) {
    return fmt::format("{} {}vertices", number, singular.substr(0, singular.size() - 6));
  }
  return fmt::format("{} {}{}", number, singular, singular.ends_with("ch") ? "es" : "s");
}

}  // namespace cirque
