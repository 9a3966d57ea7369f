#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace cirque {

/// Loops over the faces or edges of a large mesh on all cores, by oneTBB. Blocks have a fixed size
/// and their results are combined in their order: nothing depends on the number of threads.

/// How many threads the loops of this process may use while this lives; 0: as many as there are
/// cores. The smallest of several that live at once holds.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

/// The number of threads that the loops may use now.
int NumThreads();

/// How many elements of a loop one task takes: a few hundred microseconds of edge functions. Few
/// under the thread sanitizer, so that the tests' small meshes are shared between threads too.
#ifdef __SANITIZE_THREAD__
constexpr int kParallelBlock = 128;
#else
constexpr int kParallelBlock = 8192;
#endif

/// Calls body(block, begin, end) for consecutive blocks of [0, n), at once where threads allow.
/// body must not throw and must write to what belongs to its block alone.
void ForEachBlock(int n, const std::function<void(int block, int begin, int end)>& body);

/// The number of blocks of [0, n).
constexpr int NumBlocks(int n) { return (n + kParallelBlock - 1) / kParallelBlock; }

/// Calls body(i) for every i in [0, n), under the conditions of ForEachBlock.
template <class Body>
void ParallelFor(int n, const Body& body) {
  ForEachBlock(n, [&body](int, int begin, int end) {
    for (int i = begin; i < end; ++i) body(i);
  });
}

/// Calls body(i) for every i in [0, n), each a long piece of work, under the same conditions.
void ParallelTasks(int n, const std::function<void(int)>& body);

/// Calls body(i) for every i in [0, n), begun in that order as threads come free: long pieces of work
/// of different size, the longest first. Each may have parallel loops of its own, which share the
/// same threads and never take up another piece while they wait. body must not throw.
void ParallelQueue(int n, const std::function<void(int)>& body);

/// Work that goes on beside the caller's from construction to Wait(); with one thread it is done by
/// Wait(), and at once where it is about no more elements than a block has: a thread would take longer to
/// begin.
class BackgroundTask {
 public:
  BackgroundTask(std::size_t elements, std::function<void()> work);
  ~BackgroundTask();
  BackgroundTask(const BackgroundTask&) = delete;
  BackgroundTask& operator=(const BackgroundTask&) = delete;

  void Wait();

 private:
  struct Group;
  std::unique_ptr<Group> group_;  ///< null: done
};

}  // namespace cirque
