// Follows CONTRIBUTING.md: a domain in one file pair and one line of a table is mapped to, and
// refuses what does not fit, like the library's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"
#include "tests/domains/example/right_half_plane_domain.h"

namespace cirque {
namespace {

// ---- its line ----
Registry<Domain> MyDomains() {
  return Domains().With("right_half_plane",
                        {"the half-plane x > 0", {"pole"}, {"uv"}, MapToRightHalfPlane});
}

TEST(AddADomain, NothingIsFlippedAndTheBoundaryIsWhereItBelongs) {
  for (const char* name : {"hemisphere", "spherical_cap"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 400);
    const Triangulation& t = surface.triangulation;
    const auto map = MapSurface(surface, RequestFor("right_half_plane"), {}, nullptr, MyDomains());
    ASSERT_TRUE(map.ok()) << map.status().message();
    EXPECT_TRUE(FlippedFaces(t, map->uv).empty());
    const std::vector<bool> boundary = BoundaryVertices(t);
    int on_the_axis = 0, inside = 0;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      const double x = map->uv.value[h].x();
      if (x == 0) on_the_axis += boundary[t.vertex[h]];
      if (x > 0) inside += !boundary[t.vertex[h]];
      EXPECT_TRUE(x > 0 || (x == 0 && boundary[t.vertex[h]]));
    }
    EXPECT_GT(on_the_axis, 20);
    EXPECT_GT(inside, 200);
  }
}

TEST(AddADomain, ItIsTheOtherHalfPlaneTurned) {
  const Surface surface = GeneratedSurface("hemisphere", 200);
  const auto turned = MapSurface(surface, RequestFor("right_half_plane"), {}, nullptr, MyDomains());
  ASSERT_TRUE(turned.ok()) << turned.status().message();
  const SurfaceMap upper = MustMap(surface, RequestFor("half_plane"));
  for (std::size_t h = 0; h < upper.uv.value.size(); ++h) {
    EXPECT_EQ(turned->uv.value[h].x(), upper.uv.value[h].y());
    EXPECT_EQ(turned->uv.value[h].y(), -upper.uv.value[h].x());
  }
}

TEST(AddADomain, WhatDoesNotFitIsRefused) {
  const auto outcome = [](const char* surface, const MapRequest& request) {
    return MapSurface(GeneratedSurface(surface, 100), request, {}, nullptr, MyDomains()).status();
  };
  MapRequest request = RequestFor("right_half_plane");
  EXPECT_EQ(outcome("sphere", request).code(), StatusCode::kInvalidInput);
  request.cut = Cut();
  EXPECT_THAT(outcome("hemisphere", request).message(),
              testing::HasSubstr("right_half_plane takes no cut"));
  EXPECT_THAT(outcome("hemisphere", RequestFor("right_half_plain")).message(),
              testing::HasSubstr("right_half_plane"));
  EXPECT_EQ(Domains().Find("right_half_plane").status().code(), StatusCode::kInvalidInput);
}

}  // namespace
}  // namespace cirque
