#include "cirque/core/version.h"

// Written by the build; see framework/cmake/WriteCommit.cmake.
#include "cirque_commit.h"

namespace cirque {

std::string Version() { return CIRQUE_VERSION; }

std::string GitCommit() { return CIRQUE_GIT_COMMIT; }

}  // namespace cirque
