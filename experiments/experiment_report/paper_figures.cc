#include "experiments/experiment_report/paper_figures.h"

#include <spawn.h>
#include <sys/wait.h>

#include <cstdio>
#include <vector>

#include "experiments/experiment_report/assets.h"

namespace cirque::experiment_report {
namespace {

constexpr char kLooksForMatplotlib[] =
    "import importlib.util as u; raise SystemExit(u.find_spec('matplotlib') is None)";

/// Runs a program found in PATH with our own streams; its exit status, or -1.
int Run(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) {
    return -1;
  }
  int status = 0;
  if (waitpid(child, &status, 0) < 0 || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

}  // namespace

Status DrawPaperFigures(const std::string& runs_json, const std::string& convergence_json,
                        const std::string& figures_json) {
  std::fflush(stdout);  // what it prints comes after our lines
  // Another Python than the system's may come first in PATH, without the system's packages.
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    if (Run({python, "-c", kLooksForMatplotlib}) != 0) continue;
    const int status =
        Run({python, "-c", std::string(kFiguresScript), runs_json, convergence_json, figures_json});
    if (status == 0) return Status();
    return Status::InvalidInput("--pdf: " + python + " could not draw, for the reason above");
  }
  return Status::InvalidInput(
      "--pdf: no python3 with matplotlib; on Debian: apt-get install python3-matplotlib. All else "
      "has been written");
}

}  // namespace cirque::experiment_report
