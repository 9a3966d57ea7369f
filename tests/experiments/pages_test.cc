// experiments/scripts/make_page: pages whose commands are run again, in a project of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// A project of one page, whose block runs `command`.
class PagesTest : public ::testing::Test {
 protected:
  ProgramResult Make(const std::string& command) {
    project_.Write("experiments/scripts/make_page", Script());
    project_.Write("results/sums.md", "# Sums\n\nWhy.\n\n<!-- command: " + command +
                                          " -->\n| of yesterday |\n<!-- end of command -->\n\n"
                                          "What follows.\n\nMade of commit abc, 7 s.\n");
    return Run("sums");
  }

  ProgramResult Run(const std::string& arguments) const {
    return RunShell("CIRQUE_MESHES=/far/away /usr/bin/python3 " +
                    project_.Path("experiments/scripts/make_page") + " " + arguments);
  }

  std::string Page() const { return project_.Read("results/sums.md"); }

  TemporaryFolder project_;

 private:
  static std::string Script() {
    return RunShell("cat " + ProjectPath("experiments/scripts/make_page")).output;
  }
};

TEST_F(PagesTest, CommandsArePrintedAnewAndProseStays) {
  const ProgramResult made = Make("echo \"| $((20 + 3)) of $CIRQUE_MESHES/a.obj |\"; exit 1");
  ASSERT_EQ(made.exit_status, 0) << made.output;
  EXPECT_THAT(Page(), HasSubstr("# Sums\n\nWhy.\n\n<!-- command: echo"));
  EXPECT_THAT(Page(), HasSubstr("| 23 of $CIRQUE_MESHES/a.obj |\n<!-- end of command -->\n\n"
                                "What follows.\n"));
  EXPECT_THAT(Page(), Not(HasSubstr("yesterday")));
  EXPECT_THAT(Page(), Not(HasSubstr("commit abc")));
  EXPECT_THAT(Page(), ContainsRegex("Made of commit unknown, 0 s of CPU time, on 20[0-9-]+\\."));
}

TEST_F(PagesTest, APageWhoseCommandFailsStaysAsItIs) {
  const ProgramResult made = Make("echo half; exit 3");
  EXPECT_EQ(made.exit_status, 1);
  EXPECT_THAT(made.output, HasSubstr("status 3 of: echo half; exit 3"));
  EXPECT_THAT(Page(), HasSubstr("| of yesterday |"));
  EXPECT_THAT(Page(), Not(HasSubstr("\nhalf")));
}

TEST_F(PagesTest, PagesThatThereAreNotAreNamed) {
  Make("true");
  const ProgramResult made = Run("differences");
  EXPECT_EQ(made.exit_status, 2);
  EXPECT_THAT(made.output, HasSubstr("sums"));
}

TEST_F(PagesTest, EveryPageOfTheProjectSaysWhatItIsMadeBy) {
  const ProgramResult listed = RunShell("CIRQUE_MESHES=/far/away " +
                                        ProjectPath("experiments/scripts/make_page") + " --list");
  EXPECT_EQ(listed.exit_status, 0);
  for (const char* page : {"any_cones", "disks_unit", "exact_maps", "files", "spheres"}) {
    EXPECT_THAT(listed.output, HasSubstr(page));
  }
}

}  // namespace
}  // namespace cirque
