#include "experiments/common/solve_progress.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace cirque {
namespace {

IterationRecord Record() {
  IterationRecord record;
  record.iteration = 12;
  record.gradient_max = 3.4e-5;
  return record;
}

TEST(SolveProgress, SaysStageIterateAndTime) {
  const IterationRecord record = Record();
  EXPECT_EQ(ProgressText("radii", &record, 7.25), "radii, iteration 12, gradient 3.4e-05, 7.2 s");
  EXPECT_EQ(ProgressText("component 3 of 12: layout", nullptr, 0.5),
            "component 3 of 12: layout, 0.5 s");
}

TEST(SolveProgress, IsSilentWhereThereIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  SolveProgress progress(file);
  EXPECT_FALSE(progress.Control().callback);  // a solve is not asked to tell what nobody sees
  EXPECT_FALSE(progress.Control().on_stage);
  progress.Draw();
  progress.Erase();
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
  SolveProgress(nullptr).Draw();
}

TEST(SolveProgress, HandsOnTheReport) {
  std::ostringstream out;
  SolveProgress progress(nullptr);
  std::ostream report(progress.Before(out));
  report << "one " << 1 << "\ntwo";
  EXPECT_EQ(out.str(), "one 1\n");
  report.flush();
  EXPECT_EQ(out.str(), "one 1\ntwo");
}

/// What a terminal shows from the first character on, until `wanted` is among it.
std::string ReadUntil(int master, const std::string& wanted) {
  std::string text;
  while (text.find(wanted) == std::string::npos) {
    char piece[200];
    const ssize_t length = read(master, piece, sizeof piece);
    if (length <= 0) break;
    text.append(piece, static_cast<std::size_t>(length));
  }
  return text;
}

TEST(SolveProgress, ALineOfATerminalNamesTheStageAndGoesBeforeTheReport) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_TRUE(master >= 0 && grantpt(master) == 0 && unlockpt(master) == 0);
  std::FILE* terminal = std::fopen(ptsname(master), "w");
  ASSERT_NE(terminal, nullptr);
  {
    SolveProgress progress(terminal);
    const SolveControl control = progress.Control();
    control.BeginStage("radii");
    EXPECT_EQ(control.callback(Record(), Eigen::VectorXd()), CallbackAction::kContinue);
    // Nobody calls Draw: the line comes by itself.
    const std::string line = "\r\033[Kradii, iteration 12, gradient 3.4e-05, ";
    EXPECT_NE(ReadUntil(master, line).find(line), std::string::npos);
    control.BeginStage("layout");
    EXPECT_NE(ReadUntil(master, "\r\033[Klayout, ").find("layout, "), std::string::npos);
    std::ostringstream out;
    std::ostream report(progress.Before(out));
    progress.Draw();
    report << "map\n";
    EXPECT_EQ(out.str(), "map\n");
    EXPECT_NE(ReadUntil(master, " s\r\033[K").find(" s\r\033[K"), std::string::npos);
  }
  std::fclose(terminal);
  close(master);
}

}  // namespace
}  // namespace cirque
