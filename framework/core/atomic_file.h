#pragma once

#include <string>
#include <string_view>

#include "cirque/core/status.h"

namespace cirque {

/// Writes `content` to `path` whole or not at all: to a temporary name beside it, then renamed. On
/// failure the status names the path and the system's reason, and nothing is left behind.
Status WriteFileAtomically(const std::string& path, std::string_view content);

}  // namespace cirque
