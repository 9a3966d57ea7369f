#include "cirque/domains/pins.h"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
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

/// Pins of these vertices where `move` leads from the places that a map has them at.
template <class Move>
std::string Lines(const Surface& surface, const SurfaceMap& map, const std::vector<Index>& vertices,
                  const Move& move) {
  std::string lines;
  for (const Index v : vertices) {
    const Eigen::Vector2d to = move(PlaceOf(surface, map, v));
    lines += fmt::format("{} {:.17g} {:.17g}\n", surface.soup_vertex[v] + 1, to.x(), to.y());
  }
  return lines;
}

Eigen::Vector2d Bent(const Eigen::Vector2d& p) {
  return {1 + p.x() + 0.2 * p.y() * p.y(), 2 + 0.8 * p.y()};
}

TEST_F(Pins, ManyAreMetExactlyWithoutFlips) {
  const std::vector<Index> vertices = {2, 17, 33, 50, 71, 90};
  const SurfaceMap plain = MustMap(cap_, RequestFor("plane"));
  const std::string lines = Lines(cap_, plain, vertices, Bent);
  for (const char* refine_map : {"auto", "symmetric_dirichlet"}) {
    MapRequest request = Pinned(lines);
    request.options.refine_map = refine_map;
    const SurfaceMap map = MustMap(cap_, request);
    for (const Index v : vertices) {
      EXPECT_LT((PlaceOf(cap_, map, v) - Bent(PlaceOf(cap_, plain, v))).norm(), 1e-15) << v;
    }
    EXPECT_TRUE(FlippedFaces(cap_.triangulation, map.uv).empty());
    EXPECT_EQ(map.certificate.pins->pins, 6);
    EXPECT_EQ(map.certificate.pins->miss_after, 0);
    EXPECT_GT(map.certificate.pins->miss_before, 0.01);
    EXPECT_LT(map.certificate.distortion->quasi_conformal_mean, 1.5);
  }
}

TEST_F(Pins, WhereAMapHasThemAlreadyItStays) {
  const SurfaceMap plain = MustMap(cap_, RequestFor("plane"));
  const SurfaceMap map = MustMap(cap_, Pinned(Lines(cap_, plain, {2, 17, 33, 50},
                                                    [](const Eigen::Vector2d& p) { return p; })));
  EXPECT_LE(map.certificate.pins->energy_after, map.certificate.pins->energy_before + 1e-12);
  EXPECT_LT(map.certificate.pins->miss_before, 1e-12);
}

TEST_F(Pins, SoftOnesComeTheNearerTheMoreTheyWeigh) {
  const SurfaceMap plain = MustMap(cap_, RequestFor("plane"));
  MapRequest request = Pinned(Lines(cap_, plain, {2, 17, 33, 50, 71, 90}, Bent));
  double miss = 1, energy = 0;
  for (const double weight : {0.1, 10.0, 1e3, 1e5}) {
    request.shape.pin_weight = weight;
    const SurfaceMap map = MustMap(cap_, request);
    EXPECT_LT(map.certificate.pins->miss_after, miss) << weight;
    EXPECT_GT(map.certificate.pins->energy_after, energy) << weight;
    EXPECT_TRUE(FlippedFaces(cap_.triangulation, map.uv).empty());
    miss = map.certificate.pins->miss_after;
    energy = map.certificate.pins->energy_after;
  }
  EXPECT_LT(miss, 1e-3);
}

// No map without flips has a face's corners the other way round.
TEST_F(Pins, ThatNoMapCanMeetAreNamed) {
  const SurfaceMap plain = MustMap(cap_, RequestFor("plane"));
  const std::vector<Index>& corner = cap_.triangulation.vertex;
  const std::string mirrored =
      Lines(cap_, plain, {corner[0], corner[1], corner[2]},
            [](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.x(), p.y()); });
  const Certificate failed = MustFail(cap_, Pinned(mirrored), StatusCode::kNotConverged);
  EXPECT_THAT(failed.message, HasSubstr("without flipping triangles; vertex"));
  MapRequest soft = Pinned(mirrored);
  soft.shape.pin_weight = 1;
  EXPECT_TRUE(FlippedFaces(cap_.triangulation, MustMap(cap_, soft).uv).empty());
}

// Both sides of a seam stay congruent.
TEST_F(Pins, BendAMapWithSeams) {
  const Surface ring = GeneratedSurface("annulus", 400);
  const SurfaceMap plain = MustMap(ring, RequestFor("plane"));
  std::vector<bool> on_cut(ring.triangulation.num_vertices, false);
  for (Index h = 0; h < ring.triangulation.num_halfedges(); ++h) {
    if (plain.cut.edge[ring.triangulation.edge[h]]) on_cut[ring.triangulation.Tail(h)] = true;
  }
  std::vector<Index> vertices;
  for (Index v = 3; vertices.size() < 4; v += 40) {
    if (!on_cut[v]) vertices.push_back(v);
  }
  const SurfaceMap map = MustMap(ring, Pinned(Lines(ring, plain, vertices, Bent)));
  EXPECT_EQ(map.certificate.pins->miss_after, 0);
  EXPECT_TRUE(FlippedFaces(ring.triangulation, map.uv).empty());
}

TEST_F(Pins, OtherDomainsTakeNone) {
  MapRequest request = Pinned("1 0 0\n");
  request.domain = "disk";
  EXPECT_THAT(MustFail(cap_, request, StatusCode::kInvalidInput).message,
              HasSubstr("takes no pins"));
}

}  // namespace
}  // namespace cirque
