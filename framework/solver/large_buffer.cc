#include "cirque/solver/large_buffer.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cirque {
namespace {

constexpr std::size_t kPage = std::size_t{1} << 21;  ///< bytes of a large page
constexpr double kMost = 0x1p62;                     ///< bytes; beyond, there is no such memory
constexpr double kHeadroom = 1.2;  ///< factors of like patterns differ by some per cent

}  // namespace

bool LargeBuffer::Reserve(std::size_t count) {
  if (count <= capacity_) return true;
  const double wanted = kHeadroom * static_cast<double>(count) * sizeof(double);
  if (wanted > kMost) return false;
  data_.reset();
  const std::size_t bytes = (static_cast<std::size_t>(wanted) / kPage + 1) * kPage;
  data_.reset(static_cast<double*>(std::aligned_alloc(kPage, bytes)));
  capacity_ = data_ ? bytes / sizeof(double) : 0;
#ifdef __linux__
  if (data_) madvise(data_.get(), bytes, MADV_HUGEPAGE);
#endif
  return data_ != nullptr;
}

}  // namespace cirque
