#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// The words of a text of options: blanks and line ends separate them, '#' in front of a word starts
/// a comment that ends with the line, and what stands between quotes, "..." or '...', is taken as it
/// is, as in `-io "my mesh.obj"  # the input`. Errors are "path:line: ...": a quote that its line
/// does not close.
StatusOr<std::vector<std::string>> WordsOfOptions(const std::string& path, std::string_view text);

/// The same of a file, which begins with an option. Of another, which is a mesh more likely, the
/// error says so.
StatusOr<std::vector<std::string>> ReadOptionsFile(const std::string& path);

}  // namespace cirque
