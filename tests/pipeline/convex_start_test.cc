// Disks whose conformal image doubles do not hold, with lengths kept instead.
#include "cirque/pipeline/convex_start.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A tube of radius 1, open at z = 0, closed by a fan at its end.
Surface ClosedTube(int around, int along, double length) {
  PolygonSoup soup;
  for (int j = 0; j <= along; ++j) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * kPi * (i + 0.5 * j) / around;
      soup.position.emplace_back(std::cos(angle), std::sin(angle), length * j / along);
    }
  }
  const auto tip = static_cast<Index>(soup.position.size());
  soup.position.emplace_back(0, 0, length + 0.5);
  const auto add = [&](Index a, Index b, Index c) {
    for (const Index v : {a, b, c}) soup.corner.push_back(v);
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  };
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < around; ++i) {
      const int next = (i + 1) % around;
      add(j * around + i, j * around + next, (j + 1) * around + i);
      add(j * around + next, (j + 1) * around + next, (j + 1) * around + i);
    }
  }
  for (int i = 0; i < around; ++i) add(along * around + i, along * around + (i + 1) % around, tip);
  return SurfaceOf(soup);
}

TEST(EmbedInDisk, FlipsNothing) {
  const Surface tube = ClosedTube(12, 20, 80);
  const EdgeLengths lengths = MeasureEdgeLengths(tube);
  const auto uv = EmbedInDisk(MeasureSurface(tube.triangulation, lengths));
  ASSERT_TRUE(uv.has_value());
  EXPECT_TRUE(FlippedFaces(tube.triangulation, *uv).empty());
}

TEST(RefineMap, OfADiskThatDoublesDoNotHoldBeginsConvexly) {
  const auto deer = ReadSharedSurface("flipfree-deer");
  if (!deer) GTEST_SKIP();
  MapRequest request;
  request.options.refine_map = "symmetric_dirichlet:steps=5";
  const SurfaceMap map = MustMap(deer->surface, request);
  EXPECT_TRUE(map.cut.IsEmpty());
  EXPECT_TRUE(FlippedFaces(deer->surface.triangulation, map.uv).empty());
  EXPECT_EQ(map.certificate.map_refinement->map_refinement_convex_start, 1);
  EXPECT_LT(map.certificate.map_refinement->map_refinement_after,
            map.certificate.map_refinement->map_refinement_before);
}

TEST(RefineMap, OfADiskThatDoublesHoldBeginsAtTheConformalMap) {
  MapRequest request;
  request.options.refine_map = "symmetric_dirichlet";
  const SurfaceMap map = MustMap(GeneratedSurface("bumpy_terrain", 300), request);
  EXPECT_FALSE(map.certificate.map_refinement->map_refinement_convex_start.has_value());
}

}  // namespace
}  // namespace cirque
