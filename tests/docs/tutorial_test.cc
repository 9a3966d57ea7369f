// The tutorial does what it says: its blocks, run in order from an empty folder.
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

/// The content of the page's blocks of this language, one behind the other.
std::string BlocksOf(const std::string& page, const std::string& language) {
  std::ifstream file(ProjectPath(page));
  std::string blocks;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("```")) {
      inside = line == "```" + language;
    } else if (inside) {
      blocks += line + "\n";
    }
  }
  return blocks;
}

class TutorialSlow : public testing::Test {
 protected:
  ProgramResult Run(const std::string& script) {
    folder_.Write("script", "set -euo pipefail\n" + script);
    return RunShell("cd '" + folder_.path() + "' && PATH='" + ProgramFolder() +
                    "':\"$PATH\" bash script");
  }

  TemporaryFolder folder_;
};

TEST_F(TutorialSlow, EveryBlockRuns) {
  const std::string blocks = BlocksOf("framework/docs/tutorial.md", "sh");
  ASSERT_THAT(blocks, HasSubstr("circle_patterns"));
  const ProgramResult result = Run(blocks);
  EXPECT_EQ(result.exit_status, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("verdict: valid (injective)"));
  EXPECT_THAT(folder_.Read("study/report.html"), HasSubstr("Do more cones lower area distortion?"));
}

TEST_F(TutorialSlow, ABlockThatFailsIsSeen) {
  EXPECT_NE(Run("true\ncircle_patterns -io no.obj -oo out.obj\ntrue\n").exit_status, 0);
}

}  // namespace
}  // namespace cirque
