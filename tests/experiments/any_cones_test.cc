// Random cones that the solve of log scales was once at a loss with (studies any_cones).
#include <cstdio>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/equivalence/solve_log_scales.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/preflight.h"
#include "cirque/pipeline/parameterize.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/studies/random_requests.h"
#include "experiments/studies/small_surfaces.h"
#include "tests/common/exact_maps.h"

namespace cirque {
namespace {

/// A surface of the study, with its cones.
struct Drawn {
  explicit Drawn(int number) {
    Dice dice(static_cast<std::uint64_t>(number));
    const auto& kinds = SmallSurfaceKinds();
    soup = kinds[dice.Below(static_cast<int>(kinds.size()))].make(&dice);
    PreflightReport report;
    surface = *Preflight(soup, &report);
    cones = DrawCones(surface.triangulation, &dice);
  }

  PolygonSoup soup;
  Surface surface;
  ConeTargets cones;
};

Status SolveDoubled(int number, LogScalesResult* result) {
  const Drawn drawn(number);
  const auto newton = MakeSolverStrategy("newton");
  return SolveLogScales(drawn.surface.triangulation, MeasureEdgeLengths(drawn.surface), drawn.cones,
                        KeptEdges::kNoEdge, **newton, {}, result);
}

StatusOr<SurfaceMap> MapExactly(const Drawn& drawn, bool strict,
                                PatternKind pattern = PatternKind::kCircle) {
  MapRequest request;
  request.options.pattern = pattern;
  request.targets = drawn.cones;
  request.options.exact = true;
  request.options.strict = strict;
  return MapSurface(drawn.surface, request);
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

/// Needles of 1 to e^57 and more: their angles are in the third double of their lengths' logarithms.
/// Beside an angle of pi cosines decide, and what moves both ends of a needle's short side
/// must not be the rounding of angle sums (8013).
TEST(AnyCones, NeedlesOfMoreThanTwiceADoublesDigitsHaveTheirMetric) {
  for (const int number : {6951, 8013}) {
    LogScalesResult result;
    const Status status = SolveDoubled(number, &result);
    ASSERT_TRUE(status.ok()) << number << ": " << status.message();
    EXPECT_LE(result.residual, 1e-10) << number;
    EXPECT_GT(result.log_scale.maxCoeff() - result.log_scale.minCoeff(), 70) << number;
  }
}

/// A layout with small triangles in places far from each other: that of the narrowest beside the spacing
/// of doubles there.
TEST(AnyCones, WhatDoublesDoNotHoldInOneChartIsGivenInFigures) {
  LogScalesResult result;
  ASSERT_TRUE(SolveDoubled(5984, &result).ok());
  const EdgeLengths flat{(result.log_lengths.array() - result.log_lengths.maxCoeff()).exp()};
  Parameterization layout;
  const Status status = LayOutFlatMetric(result.intrinsic.triangulation, flat, nullptr, &layout);
  EXPECT_EQ(status.code(), StatusCode::kUnrepresentable);
  const std::string message(status.message());
  double width = 0, spacing = 0;
  const std::size_t at = message.find(": face ");
  ASSERT_NE(at, std::string::npos) << message;
  const char* figures = message.c_str() + at;
  ASSERT_EQ(std::sscanf(figures, ": face %*d (0-based), %lf wide, lies where doubles are %lf apart",
                        &width, &spacing),
            2)
      << message;
  EXPECT_GT(width, 0);
  EXPECT_LT(width, spacing);
}

/// An exact map of it lies about several origins, or has faces by themselves whose parts doubles do not
/// hold where they lay (7178).
TEST(AnyCones, WhatDoublesDoNotHoldInOneChartLiesAboutSeveralOrigins) {
  for (const int number : {5984, 7178}) {
    const Drawn drawn(number);
    const StatusOr<SurfaceMap> map = MapExactly(drawn, true, PatternKind::kEquivalence);
    ASSERT_TRUE(map.ok()) << number << ": " << map.status().message();
    EXPECT_GE(map->certificate.exact_map->exact_origins.value_or(1), 2) << number;
    ExpectExactMapIsAccepted(drawn.surface, *map);
  }
}

/// A path of problems is followed with u counted anew along it, too: the needles' creases are narrower
/// than a step's digits there.
TEST(AnyCones, PathsLeadToNeedlesOfFifty) {
  LogScalesResult result;
  const Status status = SolveDoubled(7647, &result);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_LE(result.residual, 1e-6);
}

/// The boundary did not come back to the double: a vertex 4e-9 off it, and a needle of 1 to e^34, whose
/// shapes doubles' lengths do not have (799, 3693); an edge of the double that came to nothing on the
/// way back to the input left no number of the map beside the exact one (9154).
TEST(AnyCones, TheDoublesHalfIsFoundInDigitsBelowADoubles) {
  for (const int number : {799, 3693, 9154}) {
    const Drawn drawn(number);
    const StatusOr<SurfaceMap> map = MapExactly(drawn, true, PatternKind::kEquivalence);
    ASSERT_TRUE(map.ok()) << number << ": " << map.status().message();
    ExpectExactMapIsAccepted(drawn.surface, *map);
  }
}

/// A refinement's step flipped no triangle and yet wound the image twice round a vertex.
TEST(AnyCones, RefinementsWindTheImageRoundNoVertex) {
  const Drawn drawn(9101);
  const StatusOr<SurfaceMap> map = MapExactly(drawn, true);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ExpectExactMapIsAccepted(drawn.surface, *map);
}

}  // namespace
}  // namespace cirque
