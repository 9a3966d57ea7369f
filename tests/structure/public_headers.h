#pragma once

#include <string>
#include <vector>

namespace cirque {

/// The lines of framework/public_headers.txt, comments apart: "cirque/FLOOR/NAME.h".
std::vector<std::string> PublicHeaders();

/// What a header includes of the library, as written: "cirque/...".
std::vector<std::string> LibraryIncludes(const std::string& text);

/// The declarations of a header outside classes and functions that no `///` explains, each as
/// "LINE: its first line". One comment may explain several declarations that follow each other
/// without a blank line. What is only announced (`class NAME;`) and specialisations need none.
std::vector<std::string> UnexplainedDeclarations(const std::string& text);

}  // namespace cirque
