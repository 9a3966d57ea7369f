#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>

#include "cirque/core/parallel.h"

namespace cirque {

/// Memory for many numbers that keeps its pages when it is used again, asks for large ones, and
/// touches them on all cores: where the system has to clear or find them first, that takes longer
/// than to compute what comes to stand there.
class LargeBuffer {
 public:
  LargeBuffer() = default;
  LargeBuffer(const LargeBuffer&) = delete;  // the work beside the caller's knows its address
  LargeBuffer& operator=(const LargeBuffer&) = delete;

  /// Begins to touch the pages of that many numbers while the caller goes on, for a first
  /// Reserve() of about as many. Does nothing when there is memory already.
  void ReserveAhead(std::size_t count);

  /// Makes room for that many numbers, whose values are undefined, and for some more while nothing
  /// of that is touched. False when memory ran out.
  bool Reserve(std::size_t count);

  /// Touches the pages of that many numbers, on all cores. @pre Reserve()
  void Touch(std::size_t count);

  /// Gives the pages beyond that many numbers back to the system until they are touched again.
  void Release(std::size_t count);

  double* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(double* data) const { std::free(data); }
  };

  bool Allocate(double count);

  std::unique_ptr<double, Free> data_;
  std::size_t capacity_ = 0, touched_ = 0;
  std::unique_ptr<BackgroundTask> touching_;
};

}  // namespace cirque
