#pragma once

#include <string>

#include "experiments/verify_map/verify.h"

namespace cirque::verify_map {

/// A few aligned lines; the last is "verdict: ...".
std::string ToText(const MapReport& report);

/// The same as one JSON object with stable snake_case keys; a number that is not known is null.
std::string ToJson(const MapReport& report);

}  // namespace cirque::verify_map
