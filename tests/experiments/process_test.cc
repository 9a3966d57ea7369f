// What a program asks of its own process and of others.
#include "experiments/common/process.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
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

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

/// Whether the heap, or a part of it, may lie on huge pages, where the system has any.
bool HeapIsAdvised() {
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) return true;
  std::ifstream mappings("/proc/self/smaps");
  std::string line;
  bool in_heap = false;
  while (std::getline(mappings, line)) {
    if (line.find('-') < line.find(' ')) in_heap = line.find("[heap]") != std::string::npos;
    if (in_heap && line.rfind("VmFlags:", 0) == 0 && line.find(" hg") != std::string::npos)
      return true;
  }
  return false;
}

/// What is resident after buffers came and went, of more than the C library keeps by itself.
double ResidentAfterBuffers() {
  std::vector<std::vector<char>> buffers;
  for (int i = 0; i < 40; ++i) buffers.emplace_back(1 << 20, 1);
  const bool touched = buffers.back().back() == 1;
  buffers.clear();
  return touched ? ResidentMib() : 0;
}

TEST(Process, ASmallHeapKeepsWhatIsFreedOnHugePages) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // as a program begins
  EXPECT_EXIT(
      {
        KeepSmallHeap();
        const bool is_kept = ResidentAfterBuffers() > 40;
        std::_Exit(is_kept && HeapIsAdvised() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

#endif

TEST(Process, CpuTimeGrowsByWork) {
  const double before = ProcessCpuSeconds();
  double sum = 0;
  for (int i = 0; ProcessCpuSeconds() - before < 0.01; ++i) sum += std::sqrt(i);
  EXPECT_GT(sum, 0);
}

}  // namespace
}  // namespace cirque
