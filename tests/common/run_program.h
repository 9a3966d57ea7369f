#pragma once

#include <string>

namespace cirque {

/// What a program of the project printed and how it ended.
struct ProgramResult {
  int exit_status = -1;
  std::string output;  ///< both streams
};

/// Runs "bin/COMMAND" through the shell, without standard input.
ProgramResult RunProgram(const std::string& command);

/// A folder of this test's own, empty, removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string Path(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace cirque
