#pragma once

#include <string>

#include "tests/common/temporary_folder.h"

namespace cirque {

/// What a program of the project printed and how it ended.
struct ProgramResult {
  int exit_status = -1;
  std::string output;  ///< both streams
};

/// Runs "bin/COMMAND" through the shell, without standard input.
ProgramResult RunProgram(const std::string& command);

/// The same for any command of the shell.
ProgramResult RunShell(const std::string& command);

}  // namespace cirque
