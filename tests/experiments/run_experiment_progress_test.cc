#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/run_experiment/run/progress.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

Record Ended(const std::string& outcome) {
  return {{"outcome", outcome}, {"message", "why\nmore"}, {"seconds", {{"total", 1.5}}}};
}

/// Everything that is on its way to the terminal: what was written arrives in pieces.
std::string ReadAll(int terminal) {
  constexpr int kPatience = 200;  // ms
  std::string text;
  pollfd waiting = {terminal, POLLIN, 0};
  while (poll(&waiting, 1, kPatience) > 0) {
    char piece[4096];
    const ssize_t size = read(terminal, piece, sizeof(piece));
    if (size <= 0) break;
    text.append(piece, static_cast<std::size_t>(size));
  }
  return text;
}

/// What a terminal is told by two of five runs, one of which was finished before.
std::string ToldToATerminal() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) return "";
  std::FILE* out = std::fopen(ptsname(terminal), "w");
  if (out == nullptr) return "";
  Progress progress(out, 5, 1);
  progress.Start("lion/a");
  progress.Start("lion/b");
  progress.Finish("lion/b", Ended("crash"));
  const std::string text = ReadAll(terminal);
  std::fclose(out);
  close(terminal);
  return text;
}

TEST(RunExperimentProgress, OnATerminalTellsDoneFailedLeftAndForHowLong) {
  const std::string text = ToldToATerminal();
  if (text.empty()) GTEST_SKIP() << "no pseudo terminals here";
  EXPECT_THAT(text, HasSubstr("\r\033[K1 done, 0 failed, 4 left; lion/a ..."));
  EXPECT_THAT(text, HasSubstr("\r\033[K1 done, 0 failed, 4 left; lion/b ..."));
  EXPECT_THAT(text, HasSubstr("\r\033[K[2/5] lion/b: crash, 1.50 s; why\r\n"));
  EXPECT_THAT(text, ::testing::EndsWith("2 done, 1 failed, 3 left, about 0 s"));
}

TEST(RunExperimentProgress, InAFileIsOneLineARun) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  Progress progress(file, 2, 0);
  progress.Start("lion/a");
  progress.Finish("lion/a", Ended("infeasible"));
  std::rewind(file);
  std::string text(4096, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  EXPECT_EQ(text, "[1/2] lion/a: infeasible, 1.50 s; why\n");
}

}  // namespace
}  // namespace cirque
