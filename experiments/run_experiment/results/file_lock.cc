#include "experiments/run_experiment/results/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace cirque {
namespace {

constexpr int kAttempts = 20;
constexpr std::chrono::milliseconds kPause(50);

}  // namespace

StatusOr<FileLock> FileLock::Take(const std::string& path) {
  FileLock lock;
  lock.descriptor_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock.descriptor_ < 0) {
    return Status::InvalidInput(fmt::format("{}: cannot open: {}", path, std::strerror(errno)));
  }
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (flock(lock.descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return lock;
    std::this_thread::sleep_for(kPause);
  }
  return Status::InvalidInput(
      path +
      ": another run_experiment writes these results; wait for its end, or give each of them "
      "a part of the runs (--shard)");
}

FileLock::FileLock(FileLock&& other) noexcept { *this = std::move(other); }

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace cirque
