#include "tests/common/run_program.h"

#include <sys/wait.h>

#include <array>
#include <cstdio>

#include <glog/logging.h>

#include "tests/common/paths.h"

namespace cirque {

ProgramResult RunProgram(const std::string& command) {
  return RunShell(ProgramFolder() + "/" + command);
}

ProgramResult RunShell(const std::string& command) {
  const std::string line = command + " < /dev/null 2>&1";
  std::FILE* pipe = popen(line.c_str(), "r");
  CHECK(pipe) << line;
  ProgramResult result;
  std::array<char, 4096> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe)) result.output += buffer.data();
  const int status = pclose(pipe);
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

}  // namespace cirque
