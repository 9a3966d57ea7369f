// What every registered cut heuristic promises, and what each is for.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/cuts/registry.h"
#include "cirque/layout/packing.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

StatusOr<Eigen::VectorXd> CostsOf(const Surface& surface, const std::string& text,
                                  double flat_scale = 1) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const EdgeLengths flat = {flat_scale * lengths.value};
  const auto heuristic = ParseCutHeuristic(text);
  if (!heuristic.ok()) return heuristic.status();
  return (*heuristic)
      ->EdgeCosts({MeasureSurface(surface.triangulation, lengths), flat, &surface.position});
}

class EveryCutHeuristic : public testing::TestWithParam<std::string> {};

TEST_P(EveryCutHeuristic, CostsAreNumbersInProportionToScaleAndTheSameAgain) {
  const Surface blob = GeneratedSurface("blob", 200);
  const Eigen::VectorXd costs = *CostsOf(blob, GetParam());
  ASSERT_EQ(costs.size(), blob.triangulation.num_edges());
  EXPECT_TRUE(costs.allFinite());
  EXPECT_GT(costs.minCoeff(), 0);
  EXPECT_EQ(*CostsOf(blob, GetParam()), costs);
  const Surface large = Moved(blob, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return 8 * x;  // exact
  });
  const Eigen::VectorXd ratio = CostsOf(large, GetParam())->cwiseQuotient(costs);
  EXPECT_NEAR(ratio.minCoeff(), 8, 1e-9);
  EXPECT_NEAR(ratio.maxCoeff(), 8, 1e-9);
}

TEST_P(EveryCutHeuristic, EndsInAMapOpenedToADisk) {
  for (const char* generator : {"blob", "torus", "double_torus", "annulus"}) {
    for (const SeamKind seams : {SeamKind::kRigid, SeamKind::kFree}) {
      const Surface surface = GeneratedSurface(generator, 600);
      ParameterizeOptions options;
      options.cut_cost = GetParam();
      options.seams = seams;
      Parameterization map;
      const Status status = Parameterize(surface, {options}, {}, &map);
      ASSERT_TRUE(status.ok()) << generator << ": " << status.message();
      EXPECT_EQ(EulerCharacteristic(CutOpen(surface.triangulation, map.cut)), 1);
      EXPECT_EQ(map.certificate.layout->flipped_triangles, 0);
      const LayoutSummary& layout = *map.certificate.layout;
      EXPECT_GT(*layout.visible_cut_length, 0);
      EXPECT_LE(*layout.visible_cut_length, *layout.cut_length);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryCutHeuristic, testing::ValuesIn(CutHeuristics().Names()),
                         [](const auto& heuristic) { return heuristic.param; });

TEST(CutHeuristics, TheFullestIsThatOfTheOthersThatFillsMostOfItsSquare) {
  for (const SeamKind seams : {SeamKind::kRigid, SeamKind::kFree}) {
    const Surface surface = GeneratedSurface("double_torus", 600);
    const auto map_by = [&](const std::string& cut_cost) {
      ParameterizeOptions options;
      options.cut_cost = cut_cost;
      options.seams = seams;
      Parameterization map;
      EXPECT_TRUE(Parameterize(surface, {options}, {}, &map).ok()) << cut_cost;
      return map;
    };
    double most = 0, least = 1;
    for (const std::string& name : CutHeuristics().Names()) {
      if (name == "fullest") continue;
      const double used = AreaUsed(map_by(name).uv);
      most = std::max(most, used), least = std::min(least, used);
    }
    const Parameterization fullest = map_by("fullest");
    EXPECT_EQ(AreaUsed(fullest.uv), most);
    EXPECT_LT(least, 0.99 * most);
    EXPECT_EQ(fullest.certificate.layout->cuts_tried, 5);
  }
}

TEST(CutHeuristics, AHalfFilledSquareIsHalfUsed) {
  const CornerUv triangle{{{0, 0}, {3, 0}, {3, 3}}};
  EXPECT_EQ(AreaUsed(triangle), 0.5);
  EXPECT_EQ(AreaUsed(CornerUv()), 0);
}

TEST(CutHeuristics, LengthsAreThemselvesAndNothingCostsMoreThanItsLength) {
  const Surface blob = GeneratedSurface("blob", 200);
  const Eigen::VectorXd length = MeasureEdgeLengths(blob).value;
  EXPECT_EQ(*CostsOf(blob, "length", 3), length);
  EXPECT_EQ(*CostsOf(blob, "flat_length", 3), 3 * length);
  EXPECT_EQ(*CostsOf(blob, "distortion"), length);  // an isometry prefers no edge
  for (const char* name : {"distortion", "curvature"}) {
    const Eigen::VectorXd share = CostsOf(blob, name, 3)->cwiseQuotient(length);
    EXPECT_GT(share.minCoeff(), 0) << name;
    EXPECT_LE(share.maxCoeff(), 1) << name;
  }
  // Half of what is preferred lies above the mean, half below: costs differ.
  const Eigen::VectorXd share = CostsOf(blob, "curvature")->cwiseQuotient(length);
  EXPECT_LT(share.minCoeff(), 0.5);
  EXPECT_GT(share.maxCoeff(), 0.5);
}

TEST(CutHeuristics, CreasesAreCheaperThanWhatIsFlat) {
  // The corners of a regular octahedron are all alike.
  const Surface octahedron = RegularPolyhedron(8);
  const Eigen::VectorXd alike = *CostsOf(octahedron, "curvature");
  const Eigen::VectorXd length = MeasureEdgeLengths(octahedron).value;
  EXPECT_LT((alike - length / 2).cwiseAbs().maxCoeff(), 1e-12);  // l / (1 + K / K)
  // A fan's apex is its one inner vertex: edges at it cost less than those of the rim.
  const Surface fan = Fan(6, 0.8);
  const Triangulation& t = fan.triangulation;
  const Eigen::VectorXd cost = *CostsOf(fan, "curvature"), own = MeasureEdgeLengths(fan).value;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (t.IsBoundaryEdge(e)) {
      EXPECT_EQ(cost[e], own[e]);
    } else {
      EXPECT_LT(cost[e], 0.7 * own[e]);
    }
  }
}

TEST(CutHeuristics, WhatIsSeenFromFewSidesIsCheap) {
  // A quarter of all directions see the back of the inner rim of a torus less than its outer one.
  const Surface torus = GeneratedSurface("torus", 800);
  const Triangulation& t = torus.triangulation;
  const Eigen::VectorXd share =
      CostsOf(torus, "visibility:directions=200")->cwiseQuotient(MeasureEdgeLengths(torus).value);
  EXPECT_GT(share.minCoeff(), 0);
  EXPECT_LE(share.maxCoeff(), 1);
  double inner = 0, outer = 0, inner_edges = 0, outer_edges = 0, reach = 0;
  const auto radius = [&](Index e) {
    const Index h = t.edge_halfedge[e];
    return (torus.position[t.Tail(h)] + torus.position[t.Tip(h)]).head<2>().norm() / 2;
  };
  for (Index e = 0; e < t.num_edges(); ++e) reach = std::max(reach, radius(e));
  for (Index e = 0; e < t.num_edges(); ++e) {
    const bool is_outer = radius(e) > 0.9 * reach;
    (is_outer ? outer : inner) += share[e];
    (is_outer ? outer_edges : inner_edges) += 1;
  }
  EXPECT_GT(outer / outer_edges, 0.45);
  EXPECT_LT(inner / inner_edges, 0.9 * outer / outer_edges);
}

TEST(CutHeuristics, VisibilityMakesAVisiblyShorterCut) {
  for (const char* generator : {"torus", "double_torus"}) {
    const Surface surface = GeneratedSurface(generator, 1500);
    const auto visible = [&](const std::string& cost) {
      ParameterizeOptions options;
      options.cut_cost = cost;
      Parameterization map;
      EXPECT_TRUE(Parameterize(surface, {options}, {}, &map).ok());
      return *map.certificate.layout->visible_cut_length;
    };
    EXPECT_LT(visible("visibility"), visible("length")) << generator;
  }
}

TEST(CutHeuristics, WhoDoesNotAskHowMuchOfACutIsSeenGetsTheSameMapWithoutIt) {
  const Surface torus = GeneratedSurface("torus", 200);
  ParameterizeRequest request;
  Parameterization asked, map;
  ASSERT_TRUE(Parameterize(torus, request, {}, &asked).ok());
  EXPECT_GT(*asked.certificate.layout->visible_cut_length, 0);
  request.measure_visibility = false;
  ASSERT_TRUE(Parameterize(torus, request, {}, &map).ok());
  EXPECT_FALSE(map.certificate.layout->visible_cut_length.has_value());
  EXPECT_EQ(map.certificate.layout->cut_length, asked.certificate.layout->cut_length);
  EXPECT_EQ(map.uv.value, asked.uv.value);
}

TEST(CutHeuristics, WhatLooksAtASurfaceNeedsPoints) {
  const Surface torus = GeneratedSurface("torus", 200);
  ParameterizeOptions options;
  options.cut_cost = "visibility";
  Parameterization map;
  const Status status =
      Parameterize(torus.triangulation, MeasureEdgeLengths(torus), {options}, {}, &map);
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr("a metric has no points"));
  options.cut_cost = "length";
  ASSERT_TRUE(
      Parameterize(torus.triangulation, MeasureEdgeLengths(torus), {options}, {}, &map).ok());
  EXPECT_FALSE(map.certificate.layout->visible_cut_length.has_value());
}

TEST(CutHeuristics, UnknownNamesAndOptionsAreRefused) {
  const auto message = [](const std::string& text) { return CheckCutHeuristic(text).message(); };
  EXPECT_EQ(message("visibility:directions=7"), "");
  EXPECT_THAT(message("lenght"), HasSubstr("did you mean 'length'?"));
  EXPECT_THAT(message("visibility:direction=7"), HasSubstr("did you mean 'directions'?"));
  EXPECT_THAT(message("visibility:directions=5000"), HasSubstr("[1, 4096]"));
  EXPECT_THAT(message("curvature:power=2"), HasSubstr("unknown curvature option"));
}

}  // namespace
}  // namespace cirque
