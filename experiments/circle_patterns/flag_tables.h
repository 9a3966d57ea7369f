#pragma once

#include <string>

#include "cirque/core/option_table.h"

#include "experiments/circle_patterns/job.h"

namespace cirque {

/// What the flags say beside the job.
struct ProgramSettings {
  std::string measures;  ///< as of ParseMeasureFiles
  int threads = 0;       ///< most threads; 0: as the environment has it
  bool quiet = false;    ///< no report, no progress
  bool certificate_help = false;
};

/// The flags that are the program's own; the others are those of the library's tables.
const OptionTable<ProgramSettings>& SettingsTable();
const OptionTable<CirclePatternsJob>& JobTable();
const OptionTable<DomainRequest>& DomainTable();

}  // namespace cirque
