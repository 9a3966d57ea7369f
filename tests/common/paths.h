#pragma once

#include <string>

namespace cirque {

/// `relative` to the top of the project, e.g. "configs" or "../shared/meshes/bff-face.obj".
std::string ProjectPath(const std::string& relative);

/// The folder of the built programs.
std::string ProgramFolder();

}  // namespace cirque
