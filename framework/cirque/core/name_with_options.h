#pragma once

#include <string>

#include "cirque/core/option.h"
#include "cirque/core/status.h"

namespace cirque {

/// A name of a registry and options for what it names, as flags and configs hold them in one text:
/// "NAME" or "NAME:KEY=VALUE,KEY=VALUE".
struct NameWithOptions {
  std::string name;
  OptionMap options;
};

/// Errors (invalid input): an empty name, an option without '=', a key that is empty or given
/// twice.
StatusOr<NameWithOptions> ParseNameWithOptions(const std::string& text);

}  // namespace cirque
