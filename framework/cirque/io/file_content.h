#pragma once

#include <string>

#include "cirque/core/status.h"

namespace cirque {

/// The bytes of a file (or pipe), by one read into one buffer. Not mapped: a file that shrinks
/// while it is read would end the process. Errors name the path and the system's reason.
StatusOr<std::string> ReadFileContent(const std::string& path);

}  // namespace cirque
