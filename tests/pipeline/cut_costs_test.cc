#include "cirque/pipeline/cut_costs.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/shortest_path.h"
#include "cirque/mesh/surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

StatusOr<Eigen::VectorXd> CostsOf(const Surface& surface, const std::string& word,
                                  double flat_scale = 1) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const EdgeLengths flat = {flat_scale * lengths.value};
  ParameterizeOptions options;
  options.cut_cost = *FromWord<CutCost>(word);
  return CutCosts(MeasureSurface(surface.triangulation, lengths), flat, options,
                  surface.soup_vertex);
}

TEST(CutCosts, LengthsAreThemselvesAndNothingCostsMoreThanItsLength) {
  const Surface blob = GeneratedSurface("blob", 200);
  const Eigen::VectorXd length = MeasureEdgeLengths(blob).value;
  EXPECT_EQ(*CostsOf(blob, "length", 3), length);
  EXPECT_EQ(*CostsOf(blob, "flat_length", 3), 3 * length);
  EXPECT_EQ(*CostsOf(blob, "distortion"), length);  // an isometry prefers no edge
  for (const char* word : {"distortion", "curvature"}) {
    const Eigen::VectorXd share = CostsOf(blob, word, 3)->cwiseQuotient(length);
    EXPECT_GT(share.minCoeff(), 0) << word;
    EXPECT_LE(share.maxCoeff(), 1) << word;
  }
  // Half of what is preferred lies above the mean, half below: costs differ.
  const Eigen::VectorXd share = CostsOf(blob, "curvature")->cwiseQuotient(length);
  EXPECT_LT(share.minCoeff(), 0.5);
  EXPECT_GT(share.maxCoeff(), 0.5);
}

TEST(CutCosts, CreasesAreCheaperThanWhatIsFlat) {
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

TEST(CutCosts, ScaleOfTheSurfaceIsScaleOfTheCosts) {
  const Surface blob = GeneratedSurface("blob", 200);
  const Surface large = Moved(blob, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return 8 * x;  // exact
  });
  for (const std::string& word : WordsOf<CutCost>()) {
    const Eigen::VectorXd ratio = CostsOf(large, word)->cwiseQuotient(*CostsOf(blob, word));
    EXPECT_NEAR(ratio.minCoeff(), 8, 1e-9) << word;
    EXPECT_NEAR(ratio.maxCoeff(), 8, 1e-9) << word;
  }
}

TEST(CutCosts, MissingFilesAreRefused) {
  const Surface strip = FlatStrip(2, 2);
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  ParameterizeOptions options;
  options.edge_costs = testing::TempDir() + "no_such_costs.txt";
  const auto costs =
      CutCosts(MeasureSurface(strip.triangulation, lengths), lengths, options, strip.soup_vertex);
  EXPECT_EQ(costs.status().code(), StatusCode::kInvalidInput);
  EXPECT_THAT(costs.status().message(), HasSubstr("no_such_costs.txt"));
}

TEST(RelativeCutLength, IsTheLengthOverTheRootOfTheArea) {
  const Surface strip = FlatStrip(8, 2);  // of area 16
  const Triangulation& t = strip.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  Cut cut = {std::vector<bool>(t.num_edges(), false)};
  EXPECT_EQ(RelativeCutLength(surface, cut), 0);
  // Along the middle from end to end: 8 edges of length 1.
  const auto straight = CutAlongShortestPaths(t, lengths.value, {{9, 17}});
  ASSERT_TRUE(straight.ok()) << straight.status().message();
  EXPECT_NEAR(RelativeCutLength(surface, *straight), 8 / std::sqrt(16), 1e-12);
  // Edges of the boundary are open already.
  for (Index e = 0; e < t.num_edges(); ++e) cut.edge[e] = t.IsBoundaryEdge(e);
  EXPECT_EQ(RelativeCutLength(surface, cut), 0);
}

}  // namespace
}  // namespace cirque
