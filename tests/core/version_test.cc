#include "cirque/core/version.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque {
namespace {

TEST(Version, IsThreeNumbers) {
  EXPECT_THAT(Version(), testing::MatchesRegex("[0-9]+.[0-9]+.[0-9]+"));
}

TEST(Version, CommitIsHexOrUnknown) {
  EXPECT_THAT(GitCommit(),
              testing::AnyOf("unknown", testing::MatchesRegex("[0-9a-f]{12,}(-dirty)?")));
}

}  // namespace
}  // namespace cirque
