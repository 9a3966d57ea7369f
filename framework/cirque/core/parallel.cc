#include "cirque/core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace cirque {

using tbb::global_control;

struct ThreadLimit::Control {
  explicit Control(std::size_t threads) : limit(global_control::max_allowed_parallelism, threads) {}
  global_control limit;
};

ThreadLimit::ThreadLimit(int threads)
    : control_(threads > 0 ? std::make_unique<Control>(threads) : nullptr) {}

ThreadLimit::~ThreadLimit() = default;

int NumThreads() {
  return static_cast<int>(global_control::active_value(global_control::max_allowed_parallelism));
}

void ForEachBlock(int n, const std::function<void(int block, int begin, int end)>& body) {
  const auto run = [&](int block) {
    const int begin = block * kParallelBlock;
    body(block, begin, std::min(n, begin + kParallelBlock));
  };
  const int blocks = NumBlocks(n);
  if (blocks == 1) return run(0);
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(0, blocks, run); });
}

void ParallelTasks(int n, const std::function<void(int)>& body) {
  if (n == 1) return body(0);
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(0, n, body); });
}

void ParallelQueue(int n, const std::function<void(int)>& body) {
  const int threads = std::min(n, NumThreads());
  if (threads <= 1) {
    for (int i = 0; i < n; ++i) body(i);
    return;
  }
  std::atomic<int> next = 0;
  ParallelTasks(threads, [&](int) {
    for (int i = next++; i < n; i = next++) {
      // An arena of its own: a thread that waits in it does no work of another piece.
      tbb::task_arena arena(NumThreads());
      arena.execute([&] { body(i); });
    }
  });
}

struct BackgroundTask::Group {
  tbb::task_group tasks;
};

BackgroundTask::BackgroundTask(std::size_t elements, std::function<void()> work) {
  if (elements <= kParallelBlock) {
    work();
    return;
  }
  group_ = std::make_unique<Group>();
  group_->tasks.run(std::move(work));
}

BackgroundTask::~BackgroundTask() { Wait(); }

void BackgroundTask::Wait() {
  if (group_) group_->tasks.wait();
}

}  // namespace cirque
