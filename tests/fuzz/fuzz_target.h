#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/status.h"

namespace cirque::testing {

/// A parser that takes whatever bytes it is given.
struct FuzzTarget {
  std::string name;
  /// Parses the bytes and judges what comes out: a CHECK ends the process where the parser breaks
  /// a promise of its own, as the sanitizers do where it breaks the language's.
  std::function<void(std::string_view bytes)> run;
  std::vector<std::string> words = {};  ///< what the format gives a meaning to: the dictionary
  std::vector<std::string> seeds = {};  ///< valid inputs, small: where fuzzing starts
  /// The parser's sources, as beginnings of paths in the project: what its coverage is counted over.
  std::vector<std::string> sources = {};
};

/// The targets of each program; a format or a table of options is one by being registered.
std::vector<FuzzTarget> MeshTargets();
std::vector<FuzzTarget> SideFileTargets();
std::vector<FuzzTarget> VerifierTargets();
std::vector<FuzzTarget> OptionTargets();
std::vector<FuzzTarget> ExperimentTargets();

/// All of them.
std::vector<FuzzTarget> FuzzTargets();

/// Ends the process unless it is a refusal as parsers make them: invalid input, and a message that
/// begins with `where`.
void CheckRefusal(const Status& status, std::string_view where);

}  // namespace cirque::testing
