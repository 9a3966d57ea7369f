#pragma once

#include <string>

namespace cirque {

/// The version of the library, "MAJOR.MINOR.PATCH".
std::string Version();

/// The first 12 digits of the git commit that was built, followed by "-dirty" when the checkout
/// held changes; "unknown" when it was built outside a checkout or without git.
std::string GitCommit();

}  // namespace cirque
