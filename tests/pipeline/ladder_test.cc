#include "cirque/pipeline/ladder.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Roads that lead where a test says.
class Ladder : public testing::Test {
 protected:
  explicit Ladder(Index triangles = 100)
      : surface_(GeneratedSurface("bumpy_terrain", triangles)),
        lengths_(MeasureEdgeLengths(surface_)),
        measured_(MeasureSurface(surface_.triangulation, lengths_)) {}

  template <class EndOf>
  Status Climb(const Road& asked, const EndOf& end_of) {
    const auto take = [&](const Road& road, Parameterization* map) {
      taken_.push_back(road);
      map->targets = FreeBoundaryTargets(surface_.triangulation);
      return end_of(road, map);
    };
    return ClimbLadder({ConeSite(measured_), asked, cut_given_}, take, &map_);
  }

  std::vector<std::string> Tried() const {
    std::vector<std::string> names;
    if (map_.certificate.ladder) {
      for (const RungSummary& rung : map_.certificate.ladder->tried) names.push_back(rung.rung);
    }
    return names;
  }

  Surface surface_;
  EdgeLengths lengths_;
  IntrinsicSurface measured_;
  bool cut_given_ = false;
  std::vector<Road> taken_;
  Parameterization map_;
};

Status Unrepresentable() { return {StatusCode::kUnrepresentable, "too wide"}; }

TEST_F(Ladder, IsNotClimbedWhereTheRoadAskedForLeadsToAMap) {
  EXPECT_TRUE(Climb({}, [](const Road&, Parameterization*) { return Status(); }).ok());
  EXPECT_EQ(taken_.size(), 1u);
  EXPECT_FALSE(map_.certificate.ladder.has_value());
}

TEST_F(Ladder, StopsAtTheFirstRoadWhenStrict) {
  Road asked;
  asked.options.strict = true;
  const Status status =
      Climb(asked, [](const Road&, Parameterization*) { return Unrepresentable(); });
  EXPECT_EQ(status.code(), StatusCode::kUnrepresentable);
  EXPECT_EQ(status.message(), "too wide");
  EXPECT_EQ(taken_.size(), 1u);
  EXPECT_FALSE(map_.certificate.ladder.has_value());
}

TEST_F(Ladder, EndsWithTheFirstMapAndSaysWhatItIsMadeWith) {
  const Status status = Climb({}, [](const Road& road, Parameterization*) {
    return road.options.cones == "moving:measure=angle" ? Status() : Unrepresentable();
  });
  EXPECT_TRUE(status.ok());
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "greedy", "moving_2"));
  const LadderSummary& ladder = *map_.certificate.ladder;
  EXPECT_EQ(ladder.rungs_tried, 2);
  EXPECT_EQ(ladder.made_with, "twice as many cones by moving");
  EXPECT_THAT(ladder.since, HasSubstr("doubles could not hold the map"));
  EXPECT_EQ(ladder.tried[0].outcome, "unrepresentable");
  EXPECT_EQ(ladder.tried[2].outcome, "ok");
  const auto json = nlohmann::json::parse(map_.certificate.ToJson())["ladder"];
  EXPECT_EQ(json["tried"][1]["rung"], "greedy");
  EXPECT_EQ(json["tried"][1]["message"], "too wide");
  EXPECT_EQ(json["made_with"], ladder.made_with);
}

TEST_F(Ladder, TriesEachRungOnceAndDeliversTheFirstFailure) {
  int calls = 0;
  const Status status = Climb({}, [&](const Road&, Parameterization*) {
    return ++calls == 1 ? Status(StatusCode::kUnrepresentable, "the first")
                        : Status(StatusCode::kNotConverged, "another");
  });
  EXPECT_EQ(status.code(), StatusCode::kUnrepresentable);
  EXPECT_THAT(status.message(), HasSubstr("the first"));
  EXPECT_THAT(status.message(), HasSubstr("other roads tried"));
  const std::vector<std::string> tried = Tried();
  EXPECT_GT(tried.size(), 4u);
  EXPECT_EQ(std::set<std::string>(tried.begin(), tried.end()).size(), tried.size());
  EXPECT_EQ(map_.certificate.ladder->made_with, "");
  const std::vector<std::string> all = LadderRungs();
  std::size_t last = 0;
  for (std::size_t i = 1; i < tried.size(); ++i) {
    const auto at =
        static_cast<std::size_t>(std::find(all.begin(), all.end(), tried[i]) - all.begin());
    EXPECT_LT(at, all.size());
    EXPECT_TRUE(i == 1 || at > last) << tried[i];
    last = at;
  }
}

TEST_F(Ladder, TargetsOfTheUserAndTheirLimitsStay) {
  Road asked;
  asked.targets = FreeBoundaryTargets(surface_.triangulation);
  asked.options.max_iterations = 7;
  Climb(asked, [](const Road&, Parameterization*) {
    return Status(StatusCode::kNotConverged, "wanders");
  }).ok();
  EXPECT_GT(taken_.size(), 1u);
  for (const Road& road : taken_) {
    ASSERT_TRUE(road.targets.has_value());
    EXPECT_EQ(road.targets->lower, asked.targets->lower);
    EXPECT_EQ(road.options.max_iterations, 7);
    EXPECT_EQ(road.options.cones, "");
  }
}

TEST_F(Ladder, RadiiThatDoNotConvergeGetMoreIterationsUnlessTheLimitIsTheUsers) {
  const auto slow = [](const Road& road, Parameterization* map) {
    Fill(&map->certificate.radii).radii_gradient = 1e-3;
    return road.options.max_iterations > 100 ? Status() : Status(StatusCode::kNotConverged, "slow");
  };
  EXPECT_TRUE(Climb({}, slow).ok());
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "more_iterations"));
  Road limited;
  limited.options.max_iterations = 50;
  EXPECT_EQ(Climb(limited, slow).code(), StatusCode::kNotConverged);
}

// Where the surface is curved its own angles are nearly coherent.
TEST_F(Ladder, RoadsAfterOneOnWhichTheDualWanderedKnowIt) {
  for (const bool wandered : {false, true}) {
    taken_.clear();
    Climb({}, [&](const Road&, Parameterization* map) {
      if (wandered && taken_.size() == 2) Fill(&map->certificate.angle_fit).angle_fit_retried = 1;
      return Unrepresentable();
    }).ok();
    ASSERT_GT(taken_.size(), 4u);
    EXPECT_TRUE(IsConedWhereCurved(taken_[taken_.size() - 2]));
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      const bool knows = wandered && i > 1 && !IsConedWhereCurved(taken_[i]);
      EXPECT_EQ(taken_[i].dual, knows ? DualFit::kWandered : DualFit::kFirst)
          << i << taken_[i].options.cones;
    }
  }
}

TEST_F(Ladder, ACutThatIsGivenGetsNoCones) {
  cut_given_ = true;
  Climb({}, [](const Road&, Parameterization*) { return Unrepresentable(); }).ok();
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "rigid_seams", "equivalence"));
  for (const Road& road : taken_) EXPECT_EQ(road.options.cones, "");
}

TEST_F(Ladder, AProofAboutTheSameTargetsIsKept) {
  Road asked;
  asked.targets = FreeBoundaryTargets(surface_.triangulation);
  const Status status = Climb(asked, [](const Road& road, Parameterization* map) {
    if (road.options.angle_solver != "interior_point") {
      return Status(StatusCode::kNotConverged, "wanders");
    }
    map->flat.infeasibility.face_multiplier = {1};
    return Status(StatusCode::kInfeasible, "proven");
  });
  EXPECT_EQ(status.code(), StatusCode::kInfeasible);
  EXPECT_FALSE(map_.flat.infeasibility.empty());
}

TEST_F(Ladder, AnInaccurateMapIsBetterThanNoneAndAnAccurateOneThanThat) {
  const auto inaccurate = [](Parameterization* map) {
    Fill(&map->certificate.layout).layout_closure = 1e-5;
    return Status();
  };
  const Status status = Climb({}, [&](const Road& road, Parameterization* map) {
    if (road.options.cones.empty()) return Unrepresentable();
    return road.options.cones == "l1" ? Status() : inaccurate(map);
  });
  EXPECT_TRUE(status.ok());
  EXPECT_EQ(map_.certificate.ladder->made_with, "cones by l1");
  EXPECT_EQ(map_.certificate.ladder->tried[1].outcome, kInaccurate);
  EXPECT_TRUE(Climb({}, [&](const Road&, Parameterization* map) { return inaccurate(map); }).ok());
  EXPECT_EQ(map_.certificate.ladder->made_with, "");
}

TEST_F(Ladder, WithoutConesAnInaccurateMapIsSoughtOnTheInputsTriangles) {
  const auto by_flips = [](const Road& road, Parameterization* map) {
    const bool flips = road.options.triangulation == SolvedTriangulation::kDelaunay;
    Fill(&map->certificate.layout).layout_closure = flips ? 1e-7 : 1e-12;
    return Status();
  };
  EXPECT_TRUE(Climb({}, by_flips).ok());
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "input_triangulation"));
}

TEST_F(Ladder, UnfoldsAtLastWhatNoFewerConesMap) {
  const Status status = Climb({}, [](const Road& road, Parameterization*) {
    return road.options.cones == "curvature_peaks:share=1" ? Status() : Unrepresentable();
  });
  EXPECT_TRUE(status.ok());
  EXPECT_EQ(Tried().back(), "unfolded");
  EXPECT_THAT(Tried(), ::testing::IsSupersetOf({"greedy", "l1", "curved_50", "curved_99"}));
}

/// Maps that are cut, of that mean distortion with the default's cones and with others.
auto Distorted(double with_default, double with_others) {
  return [=](const Road& road, Parameterization* map) {
    Fill(&map->certificate.distortion).quasi_conformal_mean =
        road.options.cones.empty() ? with_default : with_others;
    map->cut.edge = {true};
    return Status();
  };
}

TEST_F(Ladder, AMapOfNoUseGetsConesWhereTheSurfaceIsCurved) {
  EXPECT_TRUE(Climb({}, Distorted(5, 1.2)).ok());
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "curved_50"));
  EXPECT_EQ(map_.certificate.ladder->since, "the map was distorted");
  EXPECT_EQ(map_.certificate.distortion->quasi_conformal_mean, 1.2);
}

// Of a map that there is nothing is asked but what the dual finds soon.
TEST_F(Ladder, ADistortedMapIsKeptWhereTheDualFindsNoAnglesNearTheSurfacesOwn) {
  const auto distorted = Distorted(5, 1.2);
  EXPECT_TRUE(Climb({}, [&](const Road& road, Parameterization* map) {
                if (road.options.cones.empty()) return distorted(road, map);
                EXPECT_EQ(road.dual, DualFit::kOrNothing);
                return Status(StatusCode::kNotConverged, "wanders");
              }).ok());
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "curved_50", "curved_90", "curved_99"));
  EXPECT_EQ(map_.certificate.distortion->quasi_conformal_mean, 5);
}

TEST_F(Ladder, WhatIsCutToAlmostEveryVertexAndStillDistortedIsUnfolded) {
  const auto by_share = [](const Road& road, Parameterization* map) {
    map->cut.edge = {true};
    const std::string& cones = road.options.cones;
    Fill(&map->certificate.distortion).quasi_conformal_mean = cones.ends_with("0.99") ? 4 : 1;
    const bool few =
        !cones.starts_with("curvature_peaks") || cones.ends_with("0.5") || cones.ends_with("0.9");
    return few ? Unrepresentable() : Status();
  };
  EXPECT_TRUE(Climb({}, by_share).ok());
  EXPECT_EQ(Tried().back(), "unfolded");
  EXPECT_EQ(map_.certificate.ladder->made_with, "cones wherever the surface is curved");
}

TEST_F(Ladder, AMapThatOtherConesDistortAsMuchStays) {
  EXPECT_TRUE(Climb({}, Distorted(5, 3.5)).ok());
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "curved_50", "curved_90", "curved_99"));
  EXPECT_EQ(map_.certificate.ladder->made_with, "");
  EXPECT_EQ(map_.certificate.distortion->quasi_conformal_mean, 5);
  for (const double fine : {1.0, 1.4}) {
    EXPECT_TRUE(Climb({}, Distorted(fine, 1)).ok());
    EXPECT_FALSE(map_.certificate.ladder.has_value());
  }
  Road unrefined, strict;
  unrefined.options.refine_map = "none";
  strict.options.strict = true;
  for (const Road& asked : {unrefined, strict}) {
    EXPECT_TRUE(Climb(asked, Distorted(5, 1)).ok());
    EXPECT_FALSE(map_.certificate.ladder.has_value());
  }
}

class LadderOfManyVertices : public Ladder {
 protected:
  LadderOfManyVertices() : Ladder(4000) {}
};

// There cones wherever the surface is curved are many, and long seams.
TEST_F(LadderOfManyVertices, OnlyAMapOfNoUseGetsThem) {
  EXPECT_TRUE(Climb({}, Distorted(3.1, 1)).ok());
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "curved_50"));
}

TEST_F(LadderOfManyVertices, AMapOfLittleUseGetsFourTimesAsManyCones) {
  EXPECT_TRUE(Climb({}, Distorted(1.4, 1)).ok());
  EXPECT_FALSE(map_.certificate.ladder.has_value());
  EXPECT_TRUE(Climb({}, Distorted(1.6, 1.2)).ok());
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "moving_4"));
  EXPECT_EQ(map_.certificate.distortion->quasi_conformal_mean, 1.2);
  EXPECT_EQ(map_.certificate.ladder->made_with, "four times as many cones by moving");
  // Not half as much.
  EXPECT_TRUE(Climb({}, Distorted(2.9, 2.1)).ok());
  EXPECT_THAT(Tried(), ElementsAre("as_asked", "moving_4"));
  EXPECT_EQ(map_.certificate.distortion->quasi_conformal_mean, 2.9);
}

TEST_F(Ladder, CancellationEndsIt) {
  int calls = 0;
  const Status status = Climb({}, [&](const Road&, Parameterization*) {
    return ++calls < 3 ? Unrepresentable() : Status(StatusCode::kCancelled, "stop");
  });
  EXPECT_EQ(status.code(), StatusCode::kCancelled);
  EXPECT_EQ(calls, 3);
}

/// A map without flipped triangles, made by the ladder; without it the outcome is `strictly`.
Parameterization MapByLadder(const Surface& surface, StatusCode strictly) {
  ParameterizeOptions options;
  Parameterization map, strict;
  options.strict = true;
  EXPECT_EQ(Parameterize(surface, {options}, {}, &strict).code(), strictly);
  EXPECT_FALSE(strict.certificate.ladder.has_value());
  options.strict = false;
  const Status status = Parameterize(surface, {options}, {}, &map);
  EXPECT_TRUE(status.ok()) << status.message();
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
  EXPECT_EQ(map.certificate.outcome, "ok");
  EXPECT_TRUE(map.certificate.ladder.has_value());
  if (map.certificate.ladder) {
    EXPECT_EQ(map.certificate.ladder->tried.front().outcome, ToString(strictly));
    EXPECT_NE(map.certificate.ladder->made_with, "");
  }
  return map;
}

TEST(LadderOfParameterize, AnOctahedronGetsConesThatHaveAMap) {
  // With six cones of its own angles it is flat already.
  const Parameterization map = MapByLadder(RegularPolyhedron(8), StatusCode::kInfeasible);
  EXPECT_NEAR(MeasureGaussBonnetDefect(RegularPolyhedron(8).triangulation, map.targets).lower, 0,
              1e-9);
  EXPECT_LT(map.certificate.distortion->quasi_conformal_mean, 1.01);
}

TEST(LadderOfParameterize, ADiskWithoutCoherentAnglesGetsCones) {
  // A triangle split twice, three corners of every innermost vertex: these corners exceed what the
  // intersection angles leave. Spires, so that every edge is Delaunay and no flip helps.
  const Surface surface =
      Moved(Kleetope(Kleetope(FlatStrip(1, 1))), [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        const bool on_square = x.x() == 0 || x.y() == 0 || x.x() == 1 || x.y() == 1;
        const Eigen::Vector3d a(1. / 3, 1. / 3, 0), b(2. / 3, 1. / 3, 0), c(1. / 3, 2. / 3, 0),
            d(2. / 3, 2. / 3, 0);
        double nearest = 1;
        for (const Eigen::Vector3d& p : {a, b, c, d}) nearest = std::min(nearest, (x - p).norm());
        return on_square || nearest < 1e-9 ? x : x + Eigen::Vector3d(0, 0, 2);
      });
  const Parameterization map = MapByLadder(surface, StatusCode::kInfeasible);
  EXPECT_GT(*map.certificate.layout->cones, 0);
}

TEST(LadderOfParameterize, LongLimbsGetConesWhereDoublesCannotHoldTheirMap) {
  const Parameterization map = MapByLadder(TwoLimbs(200), StatusCode::kUnrepresentable);
  EXPECT_GE(*map.certificate.layout->cones, 1);
}

TEST(Parameterize, TrianglesThatVanishInSinglePrecisionAreCounted) {
  const Surface surface = TwoLimbs(80);
  ParameterizeOptions options;
  options.strict = true;
  Parameterization wide, narrow;
  ASSERT_TRUE(Parameterize(surface, {options}, {}, &wide).ok());
  EXPECT_EQ(wide.certificate.layout->flipped_triangles, 0);
  EXPECT_GT(*wide.certificate.layout->float32_vanishing_triangles, 0);
  options.cones = "greedy";
  ASSERT_TRUE(Parameterize(surface, {options}, {}, &narrow).ok());
  EXPECT_EQ(*narrow.certificate.layout->float32_vanishing_triangles, 0);
}

}  // namespace
}  // namespace cirque
