#include "cirque/domains/refine_on_shape.h"

#include <gtest/gtest.h>

#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/finish_layout.h"
#include "cirque/pipeline/options.h"

namespace cirque {
namespace {

TEST(RefinementOnShape, ComesToRestWhereTheLayoutMissesItsAccuracy) {
  const std::string by_itself = ParameterizeOptions().refine_map;
  EXPECT_TRUE(CheckRefineMap(kRefineToRest).ok());
  EXPECT_NE(by_itself, kRefineToRest);
  EXPECT_EQ(RefinementOnShape(by_itself, 2 * kAccuracy), kRefineToRest);
  EXPECT_EQ(RefinementOnShape(by_itself, kAccuracy / 2), by_itself);
  EXPECT_EQ(RefinementOnShape(by_itself, 0), by_itself);
}

TEST(RefinementOnShape, IsWhatIsNamedWhateverTheLayout) {
  for (const std::string named : {"none", "mips", "mips:steps=3"}) {
    EXPECT_EQ(RefinementOnShape(named, 1), named);
  }
}

}  // namespace
}  // namespace cirque
