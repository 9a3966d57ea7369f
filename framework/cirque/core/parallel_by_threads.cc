// core/parallel.h by plain threads instead of oneTBB: for the thread sanitizer, which sees what
// std::thread orders but not what a scheduler does that was built without it.
#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "cirque/core/parallel.h"

namespace cirque {
namespace {

/// The limits of this process that are alive.
class Limits {
 public:
  void Add(int threads) {
    const std::lock_guard lock(mutex_);
    limits_.insert(threads);
  }
  void Remove(int threads) {
    const std::lock_guard lock(mutex_);
    limits_.erase(limits_.find(threads));
  }
  int Smallest() {
    const std::lock_guard lock(mutex_);
    const int cores = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
    return limits_.empty() ? cores : *limits_.begin();
  }

 private:
  std::mutex mutex_;
  std::multiset<int> limits_;
};

Limits& LimitsOfProcess() {
  static Limits limits;
  return limits;
}

}  // namespace

struct ThreadLimit::Control {
  explicit Control(int n) : threads(n) { LimitsOfProcess().Add(threads); }
  ~Control() { LimitsOfProcess().Remove(threads); }
  int threads;
};

ThreadLimit::ThreadLimit(int threads)
    : control_(threads > 0 ? std::make_unique<Control>(threads) : nullptr) {}

ThreadLimit::~ThreadLimit() = default;

int NumThreads() { return LimitsOfProcess().Smallest(); }

void ParallelTasks(int n, const std::function<void(int)>& body) {
  const int threads = std::min(n, NumThreads());
  // Dealt out rather than taken, or the caller would have done short loops before others begin.
  const auto work = [&](int first) {
    for (int i = first; i < n; i += threads) body(i);
  };
  std::vector<std::jthread> others;
  for (int first = 1; first < threads; ++first) others.emplace_back(work, first);
  work(0);
}

void ParallelQueue(int n, const std::function<void(int)>& body) {
  std::atomic<int> next = 0;
  ParallelTasks(std::min(n, NumThreads()), [&](int) {
    for (int i = next++; i < n; i = next++) body(i);
  });
}

void ForEachBlock(int n, const std::function<void(int block, int begin, int end)>& body) {
  ParallelTasks(NumBlocks(n), [&](int block) {
    const int begin = block * kParallelBlock;
    body(block, begin, std::min(n, begin + kParallelBlock));
  });
}

struct BackgroundTask::Group {
  std::function<void()> work;
  std::thread thread;
};

BackgroundTask::BackgroundTask(std::size_t elements, std::function<void()> work) {
  if (elements <= kParallelBlock) {
    work();
    return;
  }
  group_ = std::make_unique<Group>(Group{std::move(work), {}});
  if (NumThreads() > 1) group_->thread = std::thread(group_->work);
}

BackgroundTask::~BackgroundTask() { Wait(); }

void BackgroundTask::Wait() {
  if (!group_) return;
  if (group_->thread.joinable()) {
    group_->thread.join();
  } else if (group_->work) {
    group_->work();
  }
  group_->work = nullptr;
}

}  // namespace cirque
