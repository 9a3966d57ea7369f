#include "cirque/domains/map_arrays.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone_heuristic.h"
#include "cirque/generators/generators.h"

namespace cirque {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A cube, its faces as quadrilaterals.
class Cube : public testing::Test {
 protected:
  Cube() : points_(8, 3), faces_(6, 4) {
    points_ << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
    faces_ << 3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7;
    for (Index v = 0; v < 8; ++v) unfolded_.cones.push_back({v, 1.5 * kPi, 1.5 * kPi});
    unfolded_.cut = {{0, 1}, {1, 2}, {2, 3}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  }

  Eigen::MatrixXd points_;
  Eigen::MatrixXi faces_;
  MapOptions unfolded_;
};

TEST_F(Cube, UnfoldsIntoSquares) {
  const auto map = MapSurface(points_, faces_, unfolded_);
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_EQ(map->mesh.num_polygons(), 6);
  EXPECT_EQ(map->mesh.texture.size(), 14u);
  for (Index c = 0; c < 24; ++c) {
    const Index next = c % 4 == 3 ? c - 3 : c + 1;
    const auto& uv = map->mesh.texture;
    const auto& at = map->mesh.corner_texture;
    EXPECT_NEAR((uv[at[c]] - uv[at[next]]).norm(), 1, 1e-9);
  }
}

TEST_F(Cube, MatricesSpansAndRowsAreTheSame) {
  const auto by_columns = MapSurface(points_, faces_, unfolded_);
  const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> rows = points_;
  const auto by_rows = MapSurface(rows, faces_, unfolded_);
  PolygonSoup soup;
  for (Index v = 0; v < 8; ++v) soup.position.push_back(points_.row(v));
  for (Index f = 0; f < 6; ++f) {
    for (Index k = 0; k < 4; ++k) soup.corner.push_back(faces_(f, k));
    soup.first_corner.push_back(4 * f + 4);
  }
  const auto by_spans = MapSurface(ArraysOf(soup), unfolded_);
  ASSERT_TRUE(by_columns.ok() && by_rows.ok() && by_spans.ok());
  EXPECT_EQ(by_columns->mesh.texture, by_rows->mesh.texture);
  EXPECT_EQ(by_columns->mesh.texture, by_spans->mesh.texture);
}

TEST_F(Cube, CutsThatAreNoEdgesAndVerticesThatAreNoneAreNamed) {
  unfolded_.cut = {{0, 6}};
  const Status no_edge = MapSurface(points_, faces_, unfolded_).status();
  EXPECT_EQ(no_edge.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(no_edge.message(), HasSubstr("no edge joins the vertices 0 and 6"));
  unfolded_.cut = {};
  unfolded_.cones[0].vertex = 8;
  EXPECT_THAT(MapSurface(points_, faces_, unfolded_).status().message(), HasSubstr("vertex 8"));
}

TEST_F(Cube, ConesAreGivenOneWay) {
  unfolded_.options.cones = "greedy";
  EXPECT_THAT(MapSurface(points_, faces_, unfolded_).status().message(), HasSubstr("one way"));
}

TEST_F(Cube, AngleSumsDoWhatConesDo) {
  const auto by_cones = MapSurface(points_, faces_, unfolded_);
  unfolded_.cones = {};
  unfolded_.angle_sums.assign(8, 1.5 * kPi);
  const auto by_sums = MapSurface(points_, faces_, unfolded_);
  ASSERT_TRUE(by_cones.ok() && by_sums.ok());
  EXPECT_EQ(by_cones->mesh.texture, by_sums->mesh.texture);
  unfolded_.angle_sums.resize(7);
  EXPECT_THAT(MapSurface(points_, faces_, unfolded_).status().message(), HasSubstr("7 angle sums"));
}

TEST(MapArrays, AnOwnHeuristicIsWhatTheRunUses) {
  struct Four final : ConeHeuristic {
    StatusOr<std::vector<Cone>> Choose(const ConeProblem&) const override {
      std::vector<Cone> cones;
      for (Index v = 0; v < 4; ++v) cones.push_back(ConeOfCurvature(100 * v, kPi));
      return cones;
    }
  };
  const auto sphere = GenerateMesh("sphere", {.triangles = 1000});
  const auto mesh = PreparedMesh::Make(ArraysOf(*sphere));
  ASSERT_TRUE(mesh.ok());
  MapOptions own, given;
  own.options.strict = given.options.strict = true;
  own.options.own_cones = std::make_shared<Four>();
  for (Index v = 0; v < 4; ++v) given.cones.push_back(ConeOfCurvature(100 * v, kPi));
  const auto by_own = mesh->Map(own), by_given = mesh->Map(given);
  ASSERT_TRUE(by_own.ok()) << by_own.status().message();
  ASSERT_TRUE(by_given.ok()) << by_given.status().message();
  EXPECT_EQ(by_own->mesh.texture, by_given->mesh.texture);
}

TEST(MapArrays, IsolatedVerticesKeepTheirNumbersAndHaveNoMap) {
  const std::vector<double> points = {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const std::vector<Index> corners = {1, 2, 3, 2, 4, 3};
  MapOptions options;
  ASSERT_TRUE(options.Set({{"domain", "rectangle"}}).ok());
  options.shape.corners = {1, 2, 4, 3};
  const auto map = MapSurface(MeshArrays{points, corners}, options);
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_EQ(map->mesh.corner, corners);
  EXPECT_EQ(map->uv().rows(), 4);
  options.shape.corners = {0, 2, 4, 3};
  EXPECT_THAT(MapSurface(MeshArrays{points, corners}, options).status().message(),
              HasSubstr("no face has vertex 0"));
}

TEST(MapArrays, ArraysThatAreNoMeshAreRefused) {
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto message = [&](const std::vector<Index>& corners,
                           const std::vector<Index>& first = {}) {
    return MapSurface(MeshArrays{points, corners, first}).status().message();
  };
  EXPECT_EQ(message({0, 1, 2}), "");
  EXPECT_THAT(message({0, 1, 3}), HasSubstr("corner 2 is vertex 3"));
  EXPECT_THAT(message({0, 1, -1}), HasSubstr("vertex -1"));
  EXPECT_THAT(message({0, 1}), HasSubstr("three a triangle"));
  EXPECT_THAT(message({0, 1, 2}, {0, 2}), HasSubstr("end with 3"));
  EXPECT_THAT(message({0, 1, 2}, {0, 2, 3}), HasSubstr("polygon 0 has 2 corners"));
  EXPECT_FALSE(MapSurface(Eigen::MatrixXd(3, 2), Eigen::MatrixXi(1, 3)).ok());
}

TEST(MapArrays, AFailureSaysWhere) {
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
  const std::vector<Index> corners = {0, 1, 2, 1, 0, 3, 0, 1, 4};
  MapOptions options;
  options.mesh.repair = "none";
  MapFailure failure;
  EXPECT_FALSE(MapSurface(MeshArrays{points, corners}, options, {}, &failure).ok());
  ASSERT_EQ(failure.preflight.non_manifold_edges.size(), 1u);
  EXPECT_THAT(failure.preflight.non_manifold_edges[0], testing::Pair(0, 1));
}

}  // namespace
}  // namespace cirque
