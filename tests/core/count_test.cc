#include "cirque/core/count.h"

#include <gtest/gtest.h>

namespace cirque {
namespace {

TEST(Count, OneIsNoPlural) {
  EXPECT_EQ(Count(0, "face"), "0 faces");
  EXPECT_EQ(Count(1, "boundary loop"), "1 boundary loop");
  EXPECT_EQ(Count(2, "boundary loop"), "2 boundary loops");
  EXPECT_EQ(Count(1, "inner vertex"), "1 inner vertex");
  EXPECT_EQ(Count(3, "inner vertex"), "3 inner vertices");
  EXPECT_EQ(Count(3, "patch"), "3 patches");
}

}  // namespace
}  // namespace cirque
