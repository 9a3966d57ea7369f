#include "cirque/layout/map_objective.h"

#include <cmath>

#include <gtest/gtest.h>

namespace cirque {
namespace {

TEST(EveryMapObjective, WeightIsTheDerivativeOverM) {
  for (const std::string& name : MapObjectives().Names()) {
    const MapObjective objective = *MapObjectives().Find(name);
    for (const double m : {1e-6, 5e-5, 2e-4, 0.01, 0.3, 0.9, 0.999}) {
      SCOPED_TRACE(name + " at " + std::to_string(m));
      const double step = 1e-5 * std::min(m, 1 - m);
      const auto value = [&](double x) { return objective.value(x * x); };
      const double slope = (value(m + step) - value(m - step)) / (2 * step);
      EXPECT_NEAR(objective.weight(m * m) * m, slope, 1e-6 * slope);
    }
  }
}

TEST(EveryMapObjective, GrowsFromZeroWithoutBound) {
  for (const std::string& name : MapObjectives().Names()) {
    SCOPED_TRACE(name);
    const MapObjective objective = *MapObjectives().Find(name);
    EXPECT_EQ(objective.value(0), 0);
    EXPECT_GT(objective.weight(0), 0);
    EXPECT_TRUE(std::isfinite(objective.weight(0)));
    double before = 0;
    for (double m = 1e-6; m < 1; m = std::min(1.5 * m, 0.5 * (1 + m))) {
      if (1 - m < 1e-12) break;
      EXPECT_GT(objective.value(m * m), before);
      before = objective.value(m * m);
    }
    EXPECT_GT(before, 1e9);
  }
}

TEST(MapObjective, ValuesAreThoseOfTheSingularValues) {
  for (const double ratio : {1.01, 1.5, 20.0}) {
    const double m = (ratio - 1) / (ratio + 1);
    EXPECT_NEAR(MapObjectives().Find("mips")->value(m * m), ratio + 1 / ratio - 2, 1e-12 * ratio);
    // Rounded off below m = 1e-4, where the ratio is 1.0002.
    EXPECT_NEAR(MapObjectives().Find("quasi_conformal")->value(m * m), ratio - 1, 2e-4);
  }
}

}  // namespace
}  // namespace cirque
