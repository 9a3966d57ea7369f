#include "experiments/common/solve_progress.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace cirque {
namespace {

IterationRecord Record() {
  IterationRecord record;
  record.iteration = 12;
  record.gradient_max = 3.4e-5;
  record.seconds = 1.25;
  return record;
}

TEST(SolveProgress, SaysHowFarTheSolveIs) {
  EXPECT_EQ(ProgressText(Record()), "iteration 12, gradient 3.4e-05, 1.2 s");
}

TEST(SolveProgress, IsSilentWhereThereIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  SolveProgress progress(file);
  progress.Draw(Record());
  progress.Erase();
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
  SolveProgress(nullptr).Draw(Record());
}

TEST(SolveProgress, DrawsAndErasesOneLineOnATerminal) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_TRUE(master >= 0 && grantpt(master) == 0 && unlockpt(master) == 0);
  std::FILE* terminal = std::fopen(ptsname(master), "w");
  ASSERT_NE(terminal, nullptr);
  {
    SolveProgress progress(terminal);
    const IterationCallback callback = progress.Callback();
    EXPECT_EQ(callback(Record(), Eigen::VectorXd()), CallbackAction::kContinue);  // not yet
    progress.Draw(Record());
  }
  const std::string wanted = "\r\033[K" + ProgressText(Record()) + "\r\033[K";
  std::string text;  // what was written in two pieces may arrive so
  while (text.size() < wanted.size()) {
    char piece[200];
    const ssize_t length = read(master, piece, sizeof piece);
    ASSERT_GT(length, 0);
    text.append(piece, static_cast<std::size_t>(length));
  }
  EXPECT_EQ(text, wanted);
  std::fclose(terminal);
  close(master);
}

}  // namespace
}  // namespace cirque
