#include "cirque/core/status.h"

#include <memory>
#include <set>

#include <gtest/gtest.h>

namespace cirque {
namespace {

constexpr StatusCode kCodes[] = {StatusCode::kOk,           StatusCode::kInvalidInput,
                                 StatusCode::kInfeasible,   StatusCode::kUnrepresentable,
                                 StatusCode::kNotConverged, StatusCode::kCancelled};

TEST(Status, EveryCodeHasAWordOfItsOwnAndItsExitStatus) {
  std::set<std::string> words;
  for (const StatusCode code : kCodes) words.insert(ToString(code));
  EXPECT_EQ(words.size(), std::size(kCodes));
  EXPECT_FALSE(words.contains("unknown"));
  EXPECT_EQ(ExitStatus(StatusCode::kOk), 0);
  EXPECT_EQ(ExitStatus(StatusCode::kNotConverged), 1);
  EXPECT_EQ(ExitStatus(StatusCode::kCancelled), 1);
  EXPECT_EQ(ExitStatus(StatusCode::kInvalidInput), 2);
  EXPECT_EQ(ExitStatus(StatusCode::kInfeasible), 3);
  EXPECT_EQ(ExitStatus(StatusCode::kUnrepresentable), 4);
}

TEST(Status, ContextLeadsTheMessageOfAFailureOnly) {
  const Status failed = Status::InvalidInput("no such face");
  EXPECT_FALSE(failed.ok());
  EXPECT_EQ(failed.In("a.obj:3").message(), "a.obj:3: no such face");
  EXPECT_EQ(failed.In("a.obj:3").code(), StatusCode::kInvalidInput);
  EXPECT_EQ(failed.In("inner").In("outer").message(), "outer: inner: no such face");
  EXPECT_TRUE(Status().In("a.obj").ok());
  EXPECT_EQ(Status().In("a.obj").message(), "");
}

TEST(StatusOr, HoldsAValueOrSaysWhyNot) {
  const StatusOr<int> seven = 7;
  ASSERT_TRUE(seven.ok());
  EXPECT_EQ(*seven, 7);
  EXPECT_TRUE(seven.status().ok());
  const StatusOr<int> none = Status(StatusCode::kInfeasible, "none exists");
  EXPECT_FALSE(none.ok());
  EXPECT_EQ(none.status().code(), StatusCode::kInfeasible);
  EXPECT_EQ(none.status().message(), "none exists");
}

TEST(StatusOr, HandsOverWhatCannotBeCopied) {
  StatusOr<std::unique_ptr<int>> made = std::make_unique<int>(3);
  ASSERT_TRUE(made.ok());
  const std::unique_ptr<int> taken = *std::move(made);
  EXPECT_EQ(*taken, 3);
  StatusOr<std::string> word = std::string("abc");
  word->push_back('d');
  EXPECT_EQ(*word, "abcd");
  EXPECT_EQ(word->size(), 4u);
}

}  // namespace
}  // namespace cirque
