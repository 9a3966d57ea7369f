#pragma once

#include <span>
#include <string>
#include <string_view>

#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// A source file, relative to the project, and what its content is called.
struct SourceFile {
  std::string_view path, hash;
};

/// Those that make runs, as they were when this program was built: the library without what judges
/// maps and audits energies, and what turns a planned run into a record. No document, report, test
/// or other program is among them.
std::span<const SourceFile> RunSources();

/// Names the code that makes the runs of a method: `sources`, compiler and build. A source that only
/// the runs of some methods use, such as an angle objective, counts for these alone; that which the
/// ladder may fall back on, for all that are not strict. What a commit changes elsewhere leaves the
/// name as it is.
std::string RunCode(const MethodSpec& method, std::span<const SourceFile> sources = RunSources());

}  // namespace cirque
