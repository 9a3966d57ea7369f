#pragma once

#include <string>
#include <vector>

namespace cirque {

/// What is wrong with a source file, by the project's rules of structure: floors of includes, no
/// printing from the framework, no deferred work, bounded length of files and functions.
/// `path` is relative to the top of the project. Each entry reads "PATH:LINE: what".
std::vector<std::string> Violations(const std::string& path, const std::string& text);

/// The sources of the project (.h, .cc, .cmake, .sh, CMakeLists.txt), relative to `project`.
std::vector<std::string> SourceFiles(const std::string& project);

}  // namespace cirque
