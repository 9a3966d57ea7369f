#pragma once

#include <optional>
#include <string>

namespace cirque {

/// The whole text as a number, or nothing: no octal, no trailing characters, no infinities.
std::optional<long long> ParseInteger(const std::string& text);
std::optional<double> ParseNumber(const std::string& text);

/// "true" and "false" only: YAML's other spellings of them are a trap.
std::optional<bool> ParseBoolean(const std::string& text);

}  // namespace cirque
