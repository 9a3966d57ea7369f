#include "cirque/pipeline/descend.h"

#include <atomic>

#include <gtest/gtest.h>

#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// The conformal map of a double torus with cones, whose image lies upon itself.
struct Overlapping {
  Overlapping() {
    ParameterizeOptions options;
    options.cones = "greedy:cones=12";
    EXPECT_TRUE(Parameterize(surface, {options}, {}, &map).ok());
    EXPECT_TRUE(OverlapsItself(Open(), map.uv));
  }

  Triangulation Open() const { return CutOpen(surface.triangulation, map.cut); }

  StatusOr<Descent> Descend(const std::string& refine_map,
                            const std::atomic<bool>* cancelled = nullptr) const {
    return DescendToInjective(MeasureSurface(surface.triangulation, lengths),
                              map.flat.on_input.lengths, map.cut, refine_map, cancelled);
  }

  Surface surface = GeneratedSurface("double_torus", 1200);
  EdgeLengths lengths = MeasureEdgeLengths(surface);
  Parameterization map;
};

TEST(DescendToInjective, EndsNearAConformalMapThatOverlaps) {
  const Overlapping start;
  const auto descent = start.Descend("auto");
  ASSERT_TRUE(descent.ok()) << descent.status().message();
  EXPECT_TRUE(FlippedFaces(start.surface.triangulation, descent->uv).empty());
  EXPECT_FALSE(OverlapsItself(start.Open(), descent->uv));
  EXPECT_GT(descent->steps, 0);
  EXPECT_LT(descent->after, 0.05 * descent->before);
  EXPECT_FALSE(descent->refinement.has_value());
}

TEST(DescendToInjective, LowersTheEnergyThatIsAskedFor) {
  const Overlapping start;
  const auto angles = start.Descend("auto"), lengths = start.Descend("symmetric_dirichlet");
  ASSERT_TRUE(angles.ok() && lengths.ok());
  EXPECT_FALSE(OverlapsItself(start.Open(), lengths->uv));
  EXPECT_GT(lengths->after, angles->after);  // mips, at the price of lengths
  ASSERT_TRUE(lengths->refinement.has_value());
  EXPECT_LT(lengths->refinement->map_refinement_after, lengths->refinement->map_refinement_before);
}

TEST(DescendToInjective, IsInterrupted) {
  const Overlapping start;
  const std::atomic<bool> cancelled = true;
  EXPECT_EQ(start.Descend("auto", &cancelled).status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace cirque
