#pragma once

#include <functional>
#include <string>

#include "cirque/core/status.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// Gets the key of a method that names a file, and the file's path, which it may replace.
using TakeFile = std::function<Status(const std::string& key, std::string* path)>;

/// Hands every file that the options name to `take`: `edge_costs`, and the option `file` of what is
/// named with options, as in "cones: given:file=PATH". Ends with the first status that is not ok.
/// Words that are no name with options are passed over.
Status ForEachFile(const TakeFile& take, ParameterizeOptions* options);

}  // namespace cirque
