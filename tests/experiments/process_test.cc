// What a program asks of its own process and of others.
#include "experiments/common/process.h"

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

TEST(Process, RunAndWaitGivesTheExitStatus) {
  EXPECT_EQ(RunAndWait({"sh", "-c", "exit 0"}), 0);
  EXPECT_EQ(RunAndWait({"sh", "-c", "exit 7"}), 7);
  EXPECT_EQ(RunAndWait({"/bin/sh", "-c", "exit 7"}), 7);
}

TEST(Process, RunAndWaitHandsWordsOnAsTheyAre) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("what was said");
  EXPECT_EQ(RunAndWait({"sh", "-c", "printf '%s|' \"$@\" > \"$0\"", path, "a b", "", "$HOME*"}), 0);
  EXPECT_EQ(folder.Read("what was said"), "a b||$HOME*|");
}

TEST(Process, RunAndWaitTellsOfNoProgramAndOfAViolentEnd) {
  const TemporaryFolder folder;
  const std::string no_program = folder.Write("text", "not a program");
  EXPECT_NE(RunAndWait({folder.Path("none")}), 0);
  EXPECT_NE(RunAndWait({no_program}), 0);
  EXPECT_EQ(RunAndWait({"sh", "-c", "kill -KILL $$"}), -1);
}

/// Of this process, now.
double ResidentMib() {
  std::ifstream pages("/proc/self/statm");
  double size = 0, resident = 0;
  pages >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

TEST(Process, PeakMemoryIsNoLessThanWhatIsInUse) {
  const double before = PeakMemoryMib();
  const std::vector<char> touched(64 << 20, 1);
  const double resident = ResidentMib();
  ASSERT_GT(resident, 64);
  EXPECT_GE(PeakMemoryMib(), resident - 1);  // the kernel counts in batches of pages
  EXPECT_GE(PeakMemoryMib(), before);
  EXPECT_EQ(touched.back(), 1);
}

TEST(Process, CpuTimeGrowsByWork) {
  const double before = ProcessCpuSeconds();
  double sum = 0;
  for (int i = 0; ProcessCpuSeconds() - before < 0.01; ++i) sum += std::sqrt(i);
  EXPECT_GT(sum, 0);
}

}  // namespace
}  // namespace cirque
