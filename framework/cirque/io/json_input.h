#pragma once

#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

namespace cirque {

/// How deep arrays and objects of a file may lie in one another. What walks through JSON calls
/// itself for every level, so that a line of brackets would overflow the stack.
inline constexpr int kMostJsonLevels = 100;

/// The value that a text or CBOR stands for, which must be all there is. Nothing where it is
/// malformed or deeper than that.
std::optional<nlohmann::json> ParseJson(std::string_view text);
std::optional<nlohmann::json> ParseCbor(std::string_view bytes);

}  // namespace cirque
