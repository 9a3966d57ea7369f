#include "cirque/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include <gtest/gtest.h>

namespace cirque {
namespace {

constexpr std::size_t kMany = kParallelBlock + 1;  ///< elements, worth a thread

TEST(Parallel, EveryIndexOnceInItsBlock) {
  for (const int n : {0, 1, kParallelBlock, kParallelBlock + 1, 5 * kParallelBlock + 7}) {
    std::vector<int> visits(n, 0), block_of(n, -1);
    ForEachBlock(n, [&](int block, int begin, int end) {
      for (int i = begin; i < end; ++i) ++visits[i], block_of[i] = block;
    });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), n);
    for (int i = 0; i < n; ++i) ASSERT_EQ(block_of[i], i / kParallelBlock);
  }
}

TEST(Parallel, EveryTaskOnce) {
  for (const int n : {0, 1, 40}) {
    std::vector<int> visits(n, 0);
    ParallelTasks(n, [&](int i) { ++visits[i]; });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), n);
  }
}

TEST(Parallel, AQueueBeginsInOrderAndItsPiecesHaveLoopsOfTheirOwn) {
  for (const int threads : {1, 4}) {
    const ThreadLimit limit(threads);
    std::atomic<int> sum = 0;
    std::vector<int> visits(50, 0), order;
    ParallelQueue(50, [&](int i) {
      ++visits[i];
      if (threads == 1) order.push_back(i);
      BackgroundTask aside(kMany, [&sum] { ++sum; });
      ParallelFor(3 * kParallelBlock, [&](int) { ++sum; });
      aside.Wait();
    });
    EXPECT_EQ(sum, 50 * (3 * kParallelBlock + 1));
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 50);
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
  }
}

TEST(Parallel, LoopsWaitForTheirOwnWorkAlone) {
  const ThreadLimit one(1);
  std::atomic<int> done = 0;
  BackgroundTask task(kMany, [&done] { done = 1; });
  std::atomic<int> sum = 0;
  ParallelFor(20 * kParallelBlock, [&](int) { ++sum; });
  ParallelTasks(20, [&](int) { ++sum; });
  EXPECT_EQ(sum, 20 * kParallelBlock + 20);
  EXPECT_EQ(done, 0);
  task.Wait();
  EXPECT_EQ(done, 1);
}

TEST(Parallel, LimitsHoldWhileTheyLiveAndTheSmallestWins) {
  const int all = NumThreads();
  EXPECT_GE(all, 1);
  {
    const ThreadLimit one(1), two(2), none(0);
    EXPECT_EQ(NumThreads(), 1);
  }
  EXPECT_EQ(NumThreads(), all);
}

TEST(Parallel, BackgroundTasksAreDoneAfterTheWaitWhateverTheThreads) {
  for (const int threads : {0, 1}) {
    const ThreadLimit limit(threads);
    std::atomic<int> done = 0;
    BackgroundTask task(kMany, [&done] { done = 1; });
    task.Wait();
    EXPECT_EQ(done, 1);
    {
      const BackgroundTask never_waited_for(kMany, [&done] { done = 2; });
    }
    EXPECT_EQ(done, 2);
  }
}

TEST(Parallel, SmallBackgroundTasksAreDoneAtOnce) {
  const ThreadLimit one(1);
  int done = 0;
  BackgroundTask task(kParallelBlock, [&done] { ++done; });
  EXPECT_EQ(done, 1);
  task.Wait();
  EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace cirque
