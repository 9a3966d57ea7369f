#pragma once

#include <string>

namespace cirque {

/// The version of the library, "MAJOR.MINOR.PATCH".
std::string Version();

/// The first 12 digits of the git commit that was built, followed by "-dirty" when framework/ or
/// experiments/ of the checkout held changes; "unknown" outside a checkout or without git.
std::string GitCommit();

}  // namespace cirque
