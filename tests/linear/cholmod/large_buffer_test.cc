#include "cirque/linear/cholmod/large_buffer.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <gtest/gtest.h>

namespace cirque {
namespace {

constexpr std::size_t kCount = 3'000'000;

/// Writes the first and last number and reads them back.
void ExpectWritable(const LargeBuffer& buffer, std::size_t count) {
  ASSERT_NE(buffer.data(), nullptr);
  buffer.data()[0] = 1.5;
  buffer.data()[count - 1] = -2.5;
  EXPECT_EQ(buffer.data()[0], count == 1 ? -2.5 : 1.5);
  EXPECT_EQ(buffer.data()[count - 1], -2.5);
}

TEST(LargeBuffer, IsWritableFromEndToEndAsItGrows) {
  LargeBuffer buffer;
  EXPECT_EQ(buffer.data(), nullptr);
  // About the size of a large page, 2^18 numbers, too.
  for (const std::size_t count :
       {std::size_t{1}, std::size_t{1} << 18, (std::size_t{1} << 18) + 1, kCount, 4 * kCount}) {
    ASSERT_TRUE(buffer.Reserve(count));
    ExpectWritable(buffer, count);
  }
}

TEST(LargeBuffer, KeepsItsMemoryForWhatIsNotMuchLarger) {
  LargeBuffer buffer;
  ASSERT_TRUE(buffer.Reserve(kCount));
  const double* data = buffer.data();
  ExpectWritable(buffer, kCount);
  for (const std::size_t count : {kCount, kCount / 2, std::size_t{0}, kCount + kCount / 10}) {
    ASSERT_TRUE(buffer.Reserve(count));
    EXPECT_EQ(buffer.data(), data);
    EXPECT_EQ(data[kCount - 1], -2.5) << "the pages are other ones";
  }
  ExpectWritable(buffer, kCount + kCount / 10);
}

TEST(LargeBuffer, KeepsWhatItGrewTo) {
  LargeBuffer buffer;
  ASSERT_TRUE(buffer.Reserve(kCount));
  ASSERT_TRUE(buffer.Reserve(3 * kCount));
  const double* data = buffer.data();
  ASSERT_TRUE(buffer.Reserve(kCount));
  ASSERT_TRUE(buffer.Reserve(3 * kCount));
  EXPECT_EQ(buffer.data(), data);
  ExpectWritable(buffer, 3 * kCount);
}

TEST(LargeBuffer, ReservesAheadMoreOrLessThanIsNeeded) {
  for (const std::size_t expected : {kCount / 100, kCount, 3 * kCount}) {
    LargeBuffer buffer;
    buffer.ReserveAhead(expected);
    buffer.ReserveAhead(2 * kCount);
    ASSERT_TRUE(buffer.Reserve(kCount));
    buffer.Touch(kCount);
    ExpectWritable(buffer, kCount);
  }
}

TEST(LargeBuffer, TouchingChangesNothingThatWasTouched) {
  LargeBuffer buffer;
  ASSERT_TRUE(buffer.Reserve(kCount));
  buffer.Touch(kCount);
  std::fill_n(buffer.data(), kCount, 3.5);
  buffer.Touch(kCount / 2);
  buffer.Touch(kCount);
  EXPECT_EQ(std::count(buffer.data(), buffer.data() + kCount, 3.5), kCount);
}

TEST(LargeBuffer, ReleasingKeepsWhatComesBefore) {
  LargeBuffer buffer;
  buffer.Release(0);
  ASSERT_TRUE(buffer.Reserve(kCount));
  buffer.Touch(kCount);
  std::fill_n(buffer.data(), kCount, 3.5);
  buffer.Release(kCount / 2);
  EXPECT_EQ(std::count(buffer.data(), buffer.data() + kCount / 2, 3.5), kCount / 2);
  buffer.Touch(kCount);
  ExpectWritable(buffer, kCount);
}

// The sanitizers end the program where memory runs out.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(LargeBuffer, SaysThatMemoryRanOutAndServesWhatFits) {
  LargeBuffer buffer;
  ASSERT_TRUE(buffer.Reserve(kCount));
  EXPECT_FALSE(buffer.Reserve(std::numeric_limits<std::size_t>::max() / 64));
  ASSERT_TRUE(buffer.Reserve(kCount));
  ExpectWritable(buffer, kCount);
}
#endif

}  // namespace
}  // namespace cirque
