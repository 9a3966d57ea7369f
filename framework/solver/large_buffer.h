#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>

namespace cirque {

/// Memory for many numbers that keeps its pages when it is used again, and asks for large ones.
class LargeBuffer {
 public:
  /// Makes room for that many numbers, whose values are undefined, and for some more while nothing
  /// of that is touched. False when memory ran out.
  bool Reserve(std::size_t count);

  double* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(double* data) const { std::free(data); }
  };

  std::unique_ptr<double, Free> data_;
  std::size_t capacity_ = 0;
};

}  // namespace cirque
