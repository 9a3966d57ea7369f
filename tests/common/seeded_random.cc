// Every test draws the same numbers from std::rand, and with it from Eigen's Random(), whichever
// tests ran before it in the process.

#include <cstdlib>

#include <gtest/gtest.h>

namespace cirque {
namespace {

class SeedsRandomNumbers : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override { std::srand(1); }
};

const bool kIsListening = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new SeedsRandomNumbers);
  return true;
}();

TEST(RandomNumbers, AreSeededBeforeEveryTest) {
  EXPECT_TRUE(kIsListening);
  const int first = std::rand();
  std::srand(1);
  EXPECT_EQ(first, std::rand());
}

}  // namespace
}  // namespace cirque
