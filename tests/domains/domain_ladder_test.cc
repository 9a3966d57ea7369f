#include "cirque/domains/domain_ladder.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// What the domain of these tests is asked for, and where it leads.
struct Roads {
  std::vector<MapRequest> taken;
  Status (*end_of)(const MapRequest&, SurfaceMap*) = nullptr;
};

thread_local Roads roads;

Status TakeRoad(const Surface& /*surface*/, const MapRequest& request,
                const SolveControl& /*control*/, SurfaceMap* map) {
  roads.taken.push_back(request);
  return roads.end_of(request, map);
}

Domain ADomain(std::vector<std::string> reads) { return {"", std::move(reads), {"uv"}, TakeRoad}; }

Domain LikeTheDisk() { return ADomain({"pole", "refine_map", "strict"}); }

/// Climbs on a hemisphere.
struct Climbed {
  Status status;
  SurfaceMap map;

  std::vector<std::string> Tried() const {
    std::vector<std::string> names;
    if (!map.certificate.ladder) return names;
    for (const RungSummary& rung : map.certificate.ladder->tried) names.push_back(rung.rung);
    return names;
  }
};

Climbed Climb(const Domain& domain, const MapRequest& request,
              Status (*end_of)(const MapRequest&, SurfaceMap*)) {
  roads = {{}, end_of};
  Climbed climbed;
  climbed.status =
      ClimbDomainLadder(domain, GeneratedSurface("hemisphere", 200), request, {}, &climbed.map);
  return climbed;
}

Status Rough(const MapRequest& /*request*/, SurfaceMap* map) {
  Fill(&map->certificate.layout).layout_closure = 1e-3;
  return Status();
}

Status Fails(const MapRequest& /*request*/, SurfaceMap* /*map*/) {
  return {StatusCode::kNotConverged, "lost"};
}

TEST(DomainLadder, IsNotClimbedWhereTheRequestLeadsToAMap) {
  const Climbed climbed =
      Climb(LikeTheDisk(), {}, [](const MapRequest&, SurfaceMap*) { return Status(); });
  EXPECT_TRUE(climbed.status.ok());
  EXPECT_EQ(roads.taken.size(), 1u);
  EXPECT_FALSE(climbed.map.certificate.ladder.has_value());
}

TEST(DomainLadder, StrictStopsAtTheFirst) {
  MapRequest strict;
  strict.options.strict = true;
  EXPECT_EQ(Climb(LikeTheDisk(), strict, Fails).status.code(), StatusCode::kNotConverged);
  EXPECT_EQ(roads.taken.size(), 1u);
}

TEST(DomainLadder, IsOnlyOfDomainsThatReadStrict) {
  Climb(ADomain({"pole", "refine_map"}), {}, Fails);
  EXPECT_EQ(roads.taken.size(), 1u);
}

TEST(DomainLadder, ARoughMapIsRefinedToRest) {
  const Climbed climbed = Climb(LikeTheDisk(), {}, [](const MapRequest& request, SurfaceMap* map) {
    map->certificate.disk = DiskSummary();
    Fill(&map->certificate.map_refinement).map_refinement_at_rest =
        request.options.refine_map != "auto" ? 1 : 0;
    return Rough(request, map);
  });
  EXPECT_THAT(climbed.Tried(), ElementsAre("as_asked", "refined_to_rest"));
  EXPECT_EQ(Inaccuracy(climbed.map.certificate), "");
  EXPECT_THAT(climbed.map.certificate.ladder->made_with, HasSubstr("rest"));
  EXPECT_THAT(climbed.map.certificate.ladder->since, HasSubstr("accurately"));
}

TEST(DomainLadder, ARoughMapStaysWhereNoRefinementIsWanted) {
  MapRequest request;
  request.options.refine_map = "none";
  const Climbed climbed = Climb(LikeTheDisk(), request, Rough);
  EXPECT_TRUE(climbed.status.ok());
  EXPECT_NE(Inaccuracy(climbed.map.certificate), "");
  EXPECT_EQ(roads.taken.size(), 1u);
}

TEST(DomainLadder, OfOneThatDoesNotConvergeEveryRungIsTriedOnce) {
  const Climbed climbed = Climb(LikeTheDisk(), {}, Fails);
  EXPECT_EQ(climbed.status.code(), StatusCode::kNotConverged);
  EXPECT_THAT(climbed.status.message(), HasSubstr("6 other roads tried"));
  EXPECT_THAT(climbed.Tried(),
              ElementsAre("as_asked", "more_iterations", "quadratic", "interior_point",
                          "other_pole_1", "other_pole_2", "other_pole_3"));
  // One thing is changed on each.
  EXPECT_EQ(roads.taken[1].options.max_iterations, 1000);
  EXPECT_EQ(roads.taken[2].options.max_iterations, 100);
  EXPECT_EQ(roads.taken[2].options.angle_objective, "quadratic");
  EXPECT_EQ(roads.taken[3].options.angle_solver, "interior_point");
  std::set<Index> poles;
  const std::vector<bool> boundary =
      BoundaryVertices(GeneratedSurface("hemisphere", 200).triangulation);
  for (std::size_t i = 4; i < 7; ++i) {
    EXPECT_EQ(roads.taken[i].options.angle_objective, "entropy");
    EXPECT_TRUE(boundary[roads.taken[i].shape.pole]);
    poles.insert(roads.taken[i].shape.pole);
  }
  EXPECT_EQ(poles.size(), 3u);
}

TEST(DomainLadder, TheFirstThatLeadsToAMapIsTaken) {
  const Climbed climbed = Climb(LikeTheDisk(), {}, [](const MapRequest& request, SurfaceMap* map) {
    return request.shape.pole == kNone ? Fails(request, map) : Status();
  });
  EXPECT_TRUE(climbed.status.ok());
  EXPECT_EQ(climbed.Tried().back(), "other_pole_1");
  EXPECT_EQ(climbed.map.certificate.ladder->made_with, "another pole");
}

TEST(DomainLadder, WhatTheUserNamedStays) {
  MapRequest request;
  request.shape.pole = 0;
  request.options.angle_solver = "semismooth";
  request.options.max_iterations = 7;
  EXPECT_THAT(Climb(LikeTheDisk(), request, Fails).Tried(), ElementsAre("as_asked", "quadratic"));
  EXPECT_EQ(roads.taken[1].shape.pole, 0);
}

TEST(DomainLadder, AProofAboutAnotherPoleIsNoneAboutTheRequest) {
  const Climbed climbed = Climb(LikeTheDisk(), {}, [](const MapRequest& request, SurfaceMap* map) {
    if (request.shape.pole == kNone) return Fails(request, map);
    return Status(StatusCode::kInfeasible, "no");
  });
  EXPECT_EQ(climbed.status.code(), StatusCode::kNotConverged);
}

TEST(DomainLadder, ACancelledRoadEndsIt) {
  const Climbed climbed = Climb(LikeTheDisk(), {}, [](const MapRequest& request, SurfaceMap* map) {
    if (roads.taken.size() == 1) return Fails(request, map);
    return Status(StatusCode::kCancelled, "interrupted");
  });
  EXPECT_EQ(climbed.status.code(), StatusCode::kCancelled);
  EXPECT_EQ(roads.taken.size(), 2u);
}

TEST(DomainLadder, PolygonsSpreadTheirBoundary) {
  const Climbed climbed = Climb(ADomain({"corners", "refine_map", "strict"}), {},
                                [](const MapRequest& request, SurfaceMap* /*map*/) {
                                  return request.spread_boundary
                                             ? Status()
                                             : Status(StatusCode::kUnrepresentable, "too thin");
                                });
  EXPECT_TRUE(climbed.status.ok());
  EXPECT_THAT(climbed.Tried(), ElementsAre("as_asked", "spread_boundary"));
}

TEST(DomainLadder, NamesOfRungsDiffer) {
  const std::vector<std::string> names = DomainLadderRungs();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_THAT(names, Not(Contains("as_asked")));
}

/// A square with a limb, 17 times as long as wide, from the middle of its upper side: in a
/// rectangle with its corners on the square the limb's end is e^-55 in size.
Surface SquareWithLimb() {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<Index, 3>> faces;
  constexpr Index kSide = 8, kLength = 35;
  std::vector<std::vector<Index>> at(kSide + kLength + 1, std::vector<Index>(kSide + 1, kNone));
  const auto vertex = [&](Index i, Index j) {
    Index& v = at[j][i];
    if (v == kNone) {
      v = static_cast<Index>(points.size());
      points.emplace_back(i, j, 0);
    }
    return v;
  };
  for (Index j = 0; j < kSide + kLength; ++j) {
    for (Index i = 0; i < kSide; ++i) {
      if (j >= kSide && (i < 3 || i > 4)) continue;
      const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1);
      const Index d = vertex(i, j + 1);
      if ((i + j) % 2 == 0) {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      } else {
        faces.push_back({a, b, d});
        faces.push_back({b, c, d});
      }
    }
  }
  return *SurfaceFromTriangles(points, faces);
}

TEST(RectangleDomain, ALimbThatDoublesDoNotHoldIsSpread) {
  const Surface surface = SquareWithLimb();
  MapRequest request = RequestFor("rectangle");
  for (Index v = 0; v < static_cast<Index>(surface.position.size()); ++v) {
    const double x = surface.position[v].x(), y = surface.position[v].y();
    if ((x == 0 || x == 8) && (y == 0 || y == 8)) request.shape.corners.push_back(v);
  }
  ASSERT_EQ(request.shape.corners.size(), 4u);
  // The upper side, which has the limb, goes to y = 0.
  std::iter_swap(request.shape.corners.begin(), request.shape.corners.end() - 1);
  const SurfaceMap map = MustMap(surface, request);
  EXPECT_EQ(map.certificate.outcome, "ok") << map.certificate.message;
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
  ASSERT_TRUE(map.certificate.ladder.has_value());
  EXPECT_EQ(map.certificate.ladder->tried.back().rung, "spread_boundary");
  EXPECT_LT(map.certificate.distortion->quasi_conformal_mean, 2.1);
  // On [0, m] x [0, 1], the boundary on its sides.
  const double m = *map.certificate.polygon->conformal_modulus;
  const std::vector<bool> boundary = BoundaryVertices(surface.triangulation);
  for (Index h = 0; h < surface.triangulation.num_halfedges(); ++h) {
    if (!boundary[surface.triangulation.vertex[h]]) continue;
    const Eigen::Vector2d& p = map.uv.value[h];
    EXPECT_TRUE(p.x() == 0 || p.x() == m || p.y() == 0 || p.y() == 1) << p.transpose();
  }
}

}  // namespace
}  // namespace cirque
