#include "cirque/domains/pins.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

Eigen::Vector2d PlaceOf(const Surface& surface, const SurfaceMap& map, Index v) {
  for (Index h = 0; h < surface.triangulation.num_halfedges(); ++h) {
    if (surface.triangulation.vertex[h] == v) return map.uv.value[h];
  }
  return {NAN, NAN};
}

class Pins : public ::testing::Test {
 protected:
  MapRequest Pinned(const std::string& text) const {
    MapRequest request = RequestFor("plane");
    request.shape.pins = folder_.Write("pins.txt", text);
    return request;
  }

  TemporaryFolder folder_;
  const Surface cap_ = GeneratedSurface("hemisphere", 200);
};

TEST_F(Pins, TwoGoExactlyWhereTheyAreToAndTheRestFollowsByASimilarity) {
  const SurfaceMap plain = MustMap(cap_, RequestFor("plane"));
  const SurfaceMap map = MustMap(cap_, Pinned("# corners\n4 0.1 0.2\n\n31 7 -1\n"));
  EXPECT_EQ(PlaceOf(cap_, map, 3), Eigen::Vector2d(0.1, 0.2));
  EXPECT_EQ(PlaceOf(cap_, map, 30), Eigen::Vector2d(7, -1));
  const double scale = (PlaceOf(cap_, map, 30) - PlaceOf(cap_, map, 3)).norm() /
                       (PlaceOf(cap_, plain, 30) - PlaceOf(cap_, plain, 3)).norm();
  for (std::size_t h = 0; h < map.uv.value.size(); h += 3) {
    for (const std::size_t k : {1, 2}) {
      EXPECT_NEAR((map.uv.value[h + k] - map.uv.value[h]).norm(),
                  scale * (plain.uv.value[h + k] - plain.uv.value[h]).norm(), 1e-9);
    }
  }
  EXPECT_TRUE(FlippedFaces(cap_.triangulation, map.uv).empty());
  EXPECT_NEAR(map.certificate.distortion->quasi_conformal_mean,
              plain.certificate.distortion->quasi_conformal_mean, 1e-9);
}

TEST_F(Pins, OneIsATranslation) {
  const SurfaceMap plain = MustMap(cap_, RequestFor("plane"));
  const SurfaceMap map = MustMap(cap_, Pinned("4 100 200\n"));
  EXPECT_EQ(PlaceOf(cap_, map, 3), Eigen::Vector2d(100, 200));
  const Eigen::Vector2d shift = Eigen::Vector2d(100, 200) - PlaceOf(cap_, plain, 3);
  for (std::size_t h = 0; h < map.uv.value.size(); ++h) {
    EXPECT_LT((map.uv.value[h] - plain.uv.value[h] - shift).norm(), 1e-12);
  }
}

TEST_F(Pins, FilesThatMakeNoSenseAreRefusedBeforeAnythingIsSolved) {
  for (const auto& [text, message] : {std::pair("x 1 2\n", ":1: expected a vertex"),
                                      {"1 2\n", "where it goes"},
                                      {"1 2 3 4\n", "no more"},
                                      {"1 nan 0\n", "finite"},
                                      {"100000 0 0\n", "is no vertex"},
                                      {"1 0 0\n1 2 0\n", ":2: the vertex has a pin already"},
                                      {"1 0 0\n2 0 0\n", "pinned there"},
                                      {"1 0 0\n2 1 0\n3 0 1\n", ":3: a third pin"},
                                      {"# none\n", "no pin"}}) {
    const Certificate failed = MustFail(cap_, Pinned(text), StatusCode::kInvalidInput);
    EXPECT_THAT(failed.message, HasSubstr(message)) << text;
    EXPECT_FALSE(failed.angle_fit.has_value());
  }
}

TEST_F(Pins, AVertexOnTheCutHasSeveralPlaces) {
  const Surface ring = GeneratedSurface("annulus", 300);
  const SurfaceMap plain = MustMap(ring, RequestFor("plane"));
  Index on_cut = kNone;
  for (Index e = 0; e < ring.triangulation.num_edges(); ++e) {
    if (plain.cut.edge[e]) on_cut = ring.triangulation.Tail(ring.triangulation.edge_halfedge[e]);
  }
  ASSERT_NE(on_cut, kNone);
  const std::string line = std::to_string(ring.soup_vertex[on_cut] + 1) + " 0 0\n";
  EXPECT_THAT(MustFail(ring, Pinned(line), StatusCode::kInvalidInput).message,
              HasSubstr("lies on the cut"));
}

TEST_F(Pins, OtherDomainsTakeNone) {
  MapRequest request = Pinned("1 0 0\n");
  request.domain = "disk";
  EXPECT_THAT(MustFail(cap_, request, StatusCode::kInvalidInput).message,
              HasSubstr("takes no pins"));
}

}  // namespace
}  // namespace cirque
