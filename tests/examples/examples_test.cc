// The programs of experiments/examples: short, alone with the public header, and right.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using testing::HasSubstr;

constexpr int kMostLines = 40;

constexpr char kTent[] =
    "v 2 0 0\nv 1 2 0\nv -1 2 0\nv -2 0 0\nv -1 -2 0\nv 1 -2 0\nv 0 0 1\n"
    "f 1 2 7\nf 2 3 7\nf 3 4 7\nf 4 5 7\nf 5 6 7\nf 6 1 7\n";

ProgramResult RunExample(const std::string& command) { return RunProgram("examples/" + command); }

TEST(Examples, AreShortAndSeeOnlyTheHeaderOfAll) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(ProjectPath("experiments/examples"))) {
    if (entry.path().extension() != ".cc") continue;
    ++count;
    std::ifstream file(entry.path());
    int lines = 0;
    for (std::string line; std::getline(file, line); ++lines) {
      if (!line.starts_with("#include \"")) continue;
      EXPECT_EQ(line, "#include \"cirque/cirque.h\"");
    }
    EXPECT_LE(lines, kMostLines) << entry.path();
  }
  EXPECT_EQ(count, 7);
}

TEST(Examples, FirstMap) {
  const ProgramResult run = RunExample("first_map");
  EXPECT_EQ(run.exit_status, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("outcome ok"));
}

TEST(Examples, ACubeUnfoldsIntoItsFourteenCorners) {
  const ProgramResult run = RunExample("cones_and_cut");
  EXPECT_EQ(run.exit_status, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("a cube unfolds into 14 points"));
}

TEST(Examples, OwnEnergyDrawsTheRadiiTogether) {
  const ProgramResult run = RunExample("own_energy");
  EXPECT_EQ(run.exit_status, 0) << run.output;
  std::vector<double> spread;
  for (std::size_t at = run.output.find("log radii"); at != std::string::npos;
       at = run.output.find("log radii", at + 1)) {
    double r[3] = {};
    ASSERT_EQ(std::sscanf(run.output.c_str() + at, "log radii %lf %lf %lf", r, r + 1, r + 2), 3);
    spread.push_back(*std::max_element(r, r + 3) - *std::min_element(r, r + 3));
  }
  ASSERT_EQ(spread.size(), 3u);
  EXPECT_GT(spread[0], 0.1);
  EXPECT_GT(spread[0], spread[1]);
  EXPECT_GT(spread[1], spread[2]);
}

TEST(Examples, OwnConeHeuristicIsUsedByTheRun) {
  const ProgramResult run = RunExample("own_cone_heuristic");
  EXPECT_EQ(run.exit_status, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("ok: "));
}

TEST(Examples, TheSphereIsValid) {
  const ProgramResult run = RunExample("sphere");
  EXPECT_EQ(run.exit_status, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("valid"));
}

TEST(Examples, ABatchMapsWhatItCanAndTheJudgeAgrees) {
  const TemporaryFolder folder;
  folder.Write("in/tent.obj", kTent);
  folder.Write("in/broken.obj", "v 0 0 0\nf 1 2 3\n");
  std::filesystem::create_directory(folder.Path("out"));
  const ProgramResult batch = RunExample("batch " + folder.Path("in") + " " + folder.Path("out"));
  EXPECT_EQ(batch.exit_status, 1) << batch.output;
  EXPECT_THAT(batch.output, HasSubstr("tent.obj: ok"));
  const std::string tent = folder.Path("in/tent.obj"), mapped = folder.Path("out/tent.obj");
  const ProgramResult judged = RunExample("verify_uvs " + tent + " " + mapped);
  EXPECT_EQ(judged.exit_status, 0) << judged.output;
  EXPECT_THAT(judged.output, HasSubstr("valid (injective)"));
  const ProgramResult unmapped = RunExample("verify_uvs " + tent + " " + tent);
  EXPECT_EQ(unmapped.exit_status, 1) << unmapped.output;
}

}  // namespace
}  // namespace cirque
