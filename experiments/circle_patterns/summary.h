#pragma once

#include <string>

#include "cirque/pipeline/certificate.h"

namespace cirque {

/// The evidence in a few lines for people.
std::string Summary(const Certificate& certificate);

}  // namespace cirque
