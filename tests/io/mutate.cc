#include "tests/io/mutate.h"

#include <utility>

namespace cirque::testing {

std::string Mutate(std::string bytes, std::mt19937* random) {
  const std::string telling = "0123456789-+.e/\\#\n\r\t fv\xff";
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : (*random)() % n; };
  for (std::size_t n = 1 + below(3); n > 0; --n) {
    const std::size_t at = below(bytes.size());
    const char byte =
        below(2) != 0 ? telling[below(telling.size())] : static_cast<char>(below(256));
    switch (below(8)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes.insert(at, 1 + below(4), byte);
        break;
      case 2:
        bytes.erase(at, 1 + below(4));
        break;
      default:
        if (!bytes.empty()) bytes[at] = byte;
    }
  }
  return bytes;
}

}  // namespace cirque::testing
