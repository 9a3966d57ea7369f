#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// A text's pieces, one after another.
using TextPieces = std::vector<std::string>;

/// Writes `content` to `path` whole or not at all: to a temporary name beside it, then renamed. On
/// failure the status names the path and the system's reason, and nothing is left behind.
Status WriteFileAtomically(const std::string& path, std::string_view content);
Status WriteFileAtomically(const std::string& path, const TextPieces& content);

}  // namespace cirque
