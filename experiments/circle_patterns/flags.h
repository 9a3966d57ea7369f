#pragma once

#include <string>

#include "experiments/circle_patterns/flag_tables.h"
#include "experiments/circle_patterns/job.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/common/manual.h"

namespace cirque {

/// What --help and the manual page say.
Manual ProgramManual();

/// Every flag of the program: those of its own, then a loop over the tables of the domains' and the
/// pipeline's options, so that an option there is a flag here.
class CirclePatternsFlags {
 public:
  CirclePatternsFlags();
  CirclePatternsFlags(const CirclePatternsFlags&) = delete;
  CirclePatternsFlags& operator=(const CirclePatternsFlags&) = delete;

  /// From the command line: flags, and IN and OUT by their places. A single argument names a text
  /// file with all of them, if such a file begins with a flag, or a mesh NAME.EXT, whose map then is
  /// NAME_uv.obj beside it.
  Status Parse(const std::vector<std::string>& arguments);

  /// Whether the flags make sense together, and each of them by itself, as far as can be told
  /// without reading a file; then the job that they describe.
  StatusOr<CirclePatternsJob> Job() const;

  const ProgramSettings& settings() const { return settings_; }
  const CommandLine& line() const { return line_; }
  const std::vector<std::string>& others() const { return others_; }
  std::vector<std::string> Names() const { return line_.Names(); }

 private:
  void AddShapeFlags();
  StatusOr<bool> IsFileOfOptions(const std::string& path) const;
  Status ParseFile(const std::string& path);
  void TakeFiles();
  bool IsAsked() const;
  Status CheckFiles() const;
  Status CheckDomain() const;
  Status CheckSolvers() const;

  CirclePatternsJob job_;
  ProgramSettings settings_;
  std::vector<std::string> others_;  ///< arguments that are no flags
  CommandLine line_;
};

}  // namespace cirque
