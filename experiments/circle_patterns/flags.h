#pragma once

#include <string>

#include "experiments/circle_patterns/job.h"
#include "experiments/common/flag_parsing.h"

namespace cirque {

/// What the flags say beside the job.
struct ProgramSettings {
  std::string measures;  ///< as of ParseMeasureFiles
  int threads = 0;       ///< most threads; 0: as the environment has it
  bool certificate_help = false;
  bool help = false;
};

/// Every flag of the program: those of its own, then a loop over the tables of the domains' and the
/// pipeline's options, so that an option there is a flag here.
class CirclePatternsFlags {
 public:
  CirclePatternsFlags();
  CirclePatternsFlags(const CirclePatternsFlags&) = delete;
  CirclePatternsFlags& operator=(const CirclePatternsFlags&) = delete;

  /// From the command line; a single argument that is no flag names a text file with all of them.
  Status Parse(const std::vector<std::string>& arguments);

  /// Whether the flags make sense together, and each of them by itself, as far as can be told
  /// without reading a file; then the job that they describe.
  StatusOr<CirclePatternsJob> Job() const;

  const ProgramSettings& settings() const { return settings_; }
  std::string Help() const { return line_.Help(); }
  std::vector<std::string> Names() const { return line_.Names(); }

 private:
  void AddShapeFlags();
  Status CheckFiles() const;
  Status CheckDomain() const;
  Status CheckSolvers() const;

  CirclePatternsJob job_;
  ProgramSettings settings_;
  std::vector<std::string> others_;  ///< arguments that are no flags
  CommandLine line_;
};

}  // namespace cirque
