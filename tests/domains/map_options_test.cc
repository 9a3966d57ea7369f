#include "cirque/domains/map_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using testing::HasSubstr;

TEST(UvSize, TakesItsWordsAlone) {
  UvFrame frame;
  EXPECT_TRUE(SetUvSize("scale=2.5", &frame).ok());
  EXPECT_EQ(frame.scale, 2.5);
  for (const char* wrong : {"", "units", "scale", "scale=", "scale=0", "scale=-1", "scale=nan"}) {
    EXPECT_EQ(SetUvSize(wrong, &frame).code(), StatusCode::kInvalidInput) << wrong;
  }
}

TEST(MapOptions, AreThoseOfFlagsWithWhatWasMeant) {
  MapOptions options;
  EXPECT_TRUE(options.Set({{"epsilon", "0.01"}, {"centre", "3"}, {"domain", "disk"}}).ok());
  EXPECT_EQ(options.options.epsilon, 0.01);
  EXPECT_EQ(options.shape.centre, 3);
  EXPECT_THAT(options.Set({{"center", "3"}}).message(), HasSubstr("did you mean 'centre'?"));
  EXPECT_THAT(options.Set({{"epsilon", "2"}}).message(), HasSubstr("epsilon = '2'"));
  EXPECT_THAT(options.Set({{"seams", "free"}}).message(),
              HasSubstr("the domain disk takes no seams"));
  EXPECT_FALSE(options.Set({{"domain", "dusk"}}).ok());
}

}  // namespace
}  // namespace cirque
