#include "tests/common/paths.h"

namespace cirque {

std::string ProjectPath(const std::string& relative) {
  return std::string(CIRQUE_PROJECT_DIR) + "/" + relative;
}

std::string ProgramFolder() { return CIRQUE_PROGRAM_DIR; }

}  // namespace cirque
