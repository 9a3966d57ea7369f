#include "experiments/run_experiment/config/scalars.h"

#include <charconv>
#include <cmath>

namespace cirque {
namespace {

template <class T>
std::optional<T> ParseWhole(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<long long> ParseInteger(const std::string& text) {
  return ParseWhole<long long>(text);
}

std::optional<double> ParseNumber(const std::string& text) {
  const std::optional<double> value = ParseWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<bool> ParseBoolean(const std::string& text) {
  if (text == "true") return true;
  if (text == "false") return false;
  return std::nullopt;
}

}  // namespace cirque
