#include "cirque/core/registry.h"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Function = std::function<double(double)>;

Registry<Function> Functions() {
  return {"function",
          {{"square", [](double x) { return x * x; }}, {"half", [](double x) { return x / 2; }}}};
}

TEST(Registry, FindsByNameAndKeepsItsOrder) {
  const Registry<Function> functions = Functions();
  EXPECT_THAT(functions.Names(), ElementsAre("square", "half"));
  EXPECT_EQ((*functions.Find("square"))(3), 9);
  EXPECT_EQ((*functions.Find("half"))(3), 1.5);
}

TEST(Registry, AnUnknownNameIsToldTheNearestAndAll) {
  const Status status = Functions().Find("sqare").status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_EQ(status.message(),
            "unknown function 'sqare'; did you mean 'square'? Known: square, half");
  EXPECT_FALSE(Functions().Find("").ok());
}

TEST(Registry, AnEntryMoreMakesALargerTableAndLeavesTheFirst) {
  const Registry<Function> functions = Functions();
  const Registry<Function> larger = functions.With("twice", [](double x) { return 2 * x; });
  EXPECT_THAT(larger.Names(), ElementsAre("square", "half", "twice"));
  EXPECT_EQ((*larger.Find("twice"))(3), 6);
  EXPECT_EQ((*larger.Find("square"))(3), 9);
  EXPECT_THAT(functions.Names(), ElementsAre("square", "half"));
  EXPECT_FALSE(functions.Find("twice").ok());
}

TEST(RegistryDeathTest, ANameThatIsThereIsABrokenCaller) {
  const Function zero = [](double) { return 0.; };
  EXPECT_DEATH(Functions().With("half", zero), "function 'half' is there already");
  EXPECT_DEATH(Functions().With("zero", zero).With("zero", zero), "function 'zero'");
}

TEST(Registry, EntriesAddUpInTheirOrderAndAreTold) {
  const Function zero = [](double) { return 0.; };
  const Registry<Function> functions = Functions().With("zero", zero).With("one", zero);
  EXPECT_THAT(functions.Names(), ElementsAre("square", "half", "zero", "one"));
  EXPECT_THAT(functions.Find("ones").status().message(),
              HasSubstr("did you mean 'one'? Known: square, half, zero, one"));
}

}  // namespace
}  // namespace cirque
