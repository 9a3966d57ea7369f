#include <gtest/gtest.h>

#include "cirque/core/option.h"

namespace cirque {
namespace {

TEST(NameWithOptions, IsSplit) {
  EXPECT_EQ(ParseNameWithOptions("greedy")->name, "greedy");
  const NameWithOptions parsed = *ParseNameWithOptions("given:file=/a:b=c,cones=3");
  EXPECT_EQ(parsed.name, "given");
  EXPECT_EQ(parsed.options, (OptionMap{{"file", "/a:b=c"}, {"cones", "3"}}));
}

TEST(NameWithOptions, MistakesAreNamed) {
  for (const char* bad : {"", ":a=1", "x:a", "x:=1", "x:a=1,a=2", "x:a=1,,b=2"}) {
    EXPECT_EQ(ParseNameWithOptions(bad).status().code(), StatusCode::kInvalidInput) << bad;
  }
}

}  // namespace
}  // namespace cirque
