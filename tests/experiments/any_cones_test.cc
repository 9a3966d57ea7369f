// Random cones that the solve of log scales was once at a loss with (studies any_cones).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/equivalence/solve_log_scales.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/preflight.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/studies/small_surfaces.h"

namespace cirque {
namespace {

Status SolveDoubled(int number, LogScalesResult* result) {
  Dice dice(static_cast<std::uint64_t>(number));
  const auto& kinds = SmallSurfaceKinds();
  const PolygonSoup soup = kinds[dice.Below(static_cast<int>(kinds.size()))].make(&dice);
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(soup, &report);
  if (!surface.ok()) return surface.status();
  const ConeTargets cones = DrawCones(surface->triangulation, &dice);
  const auto newton = MakeSolverStrategy("newton");
  return SolveLogScales(surface->triangulation, MeasureEdgeLengths(*surface), cones,
                        KeptEdges::kNoEdge, **newton, {}, result);
}

/// Creases between which the energy is all but linear: steps that were not searched to rest leapt to
/// and fro across them.
TEST(AnyCones, WithScalesOfTensHaveTheirMetric) {
  LogScalesResult result;
  const Status status = SolveDoubled(799, &result);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_LE(result.residual, 1e-9);
  EXPECT_GT(result.log_scale.maxCoeff() - result.log_scale.minCoeff(), 30);
}

/// Needles of 1 to e^50, whose angles twice a double's digits do not hold: that is said, with the
/// figures, and is no failure to converge.
TEST(AnyCones, BeyondTheDigitsOfLengthsAreNamedSo) {
  LogScalesResult result;
  const Status status = SolveDoubled(7647, &result);
  EXPECT_EQ(status.code(), StatusCode::kUnrepresentable) << status.message();
  EXPECT_THAT(status.message(), testing::HasSubstr("digits"));
  EXPECT_LE(result.residual, 1e-4);
  EXPECT_GT(result.log_scale.maxCoeff() - result.log_scale.minCoeff(), 50);
}

}  // namespace
}  // namespace cirque
