#pragma once

#include <string>

#include "cirque/core/status.h"

namespace cirque {

/// Keeps other processes from a file for as long as this object, or its process, lives.
class FileLock {
 public:
  /// Waits a moment where another process holds the lock, then refuses. A file system without locks
  /// gives a lock that keeps nobody out.
  static StatusOr<FileLock> Take(const std::string& path);

  FileLock() = default;
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

 private:
  int descriptor_ = -1;
};

}  // namespace cirque
