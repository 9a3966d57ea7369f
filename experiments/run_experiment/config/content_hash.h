#pragma once

#include <string>
#include <string_view>

#include "cirque/core/status.h"

namespace cirque {

/// 16 hexadecimal digits (XXH3, 64 bits) that name a content; not meant to withstand an attacker.
std::string HashOf(std::string_view content);

/// The bytes of a regular file; errors name it.
StatusOr<std::string> ReadWholeFile(const std::string& path);

}  // namespace cirque
