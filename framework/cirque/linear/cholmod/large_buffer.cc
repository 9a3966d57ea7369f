#include "cirque/linear/cholmod/large_buffer.h"

#include <algorithm>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cirque {
namespace {

constexpr std::size_t kPage = std::size_t{1} << 21;  ///< bytes of a large page
constexpr std::size_t kTouch = 512;                  ///< numbers of a small one
constexpr double kMost = 0x1p62;                     ///< bytes; beyond, there is no such memory
constexpr double kHeadroom = 1.2;  ///< factors of like patterns differ by some per cent
constexpr double kUnsure = 3;      ///< what is expected may be far less than what is wanted then

}  // namespace

void LargeBuffer::ReserveAhead(std::size_t count) {
  if (data_ || !Allocate(kUnsure * static_cast<double>(count))) return;
  touching_ = std::make_unique<BackgroundTask>(count, [this, count] {
    for (; touched_ < count; touched_ += kTouch) data_.get()[touched_] = 0;
  });
}

bool LargeBuffer::Reserve(std::size_t count) {
  if (count <= capacity_) return true;
  touching_.reset();
  return Allocate(kHeadroom * static_cast<double>(count));
}

bool LargeBuffer::Allocate(double count) {
  const double wanted = count * sizeof(double);
  if (wanted > kMost) return false;
  data_.reset();
  capacity_ = touched_ = 0;
  // Of a large page all has to be cleared, for however little.
  const std::size_t page = wanted < kPage ? kTouch * sizeof(double) : kPage;
  const std::size_t bytes = (static_cast<std::size_t>(wanted) / page + 1) * page;
  data_.reset(static_cast<double*>(std::aligned_alloc(page, bytes)));
  if (!data_) return false;
  capacity_ = bytes / sizeof(double);
#ifdef __linux__
  if (page == kPage) madvise(data_.get(), bytes, MADV_HUGEPAGE);
#endif
  return true;
}

void LargeBuffer::Touch(std::size_t count) {
  touching_.reset();
  if (count <= touched_) return;
  const std::size_t first = touched_;
  const int touches = static_cast<int>((count - first + kTouch - 1) / kTouch);
  ParallelFor(touches, [&](int i) { data_.get()[first + kTouch * i] = 0; });
  touched_ = first + kTouch * touches;
}

void LargeBuffer::Release(std::size_t count) {
  touching_.reset();
#ifdef __linux__
  const std::size_t kept = (count * sizeof(double) / kPage + 1) * kPage;
  const std::size_t bytes = capacity_ * sizeof(double);
  if (kept < bytes)
    madvise(reinterpret_cast<char*>(data_.get()) + kept, bytes - kept, MADV_DONTNEED);
#endif
  touched_ = std::min(touched_, count);
}

}  // namespace cirque
