#pragma once

#include <map>
#include <string>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// Sets the gflags defined in a program's own sources from its command line and returns the other
/// arguments. gflags itself would end the process with status 1 on the first mistake; here a
/// misspelt name or a wrong value is a status that says what was meant, and `--help` is the flag
/// help of gflags, left to the program.
/// `source` is a part of the paths of the program's sources, "experiments/run_experiment/".
/// A flag named in `value_optional` is "-" when it is given without "=VALUE". `former` has the names
/// that flags had once and have now: the old ones go on working, with a word on stderr.
StatusOr<std::vector<std::string>> ParseFlags(
    int argc, char** argv, const std::string& source,
    const std::vector<std::string>& value_optional = {},
    const std::map<std::string, std::string>& former = {});

/// One entry for each of the program's flags: name, help, default.
std::string FlagHelp(const std::string& source);

}  // namespace cirque
