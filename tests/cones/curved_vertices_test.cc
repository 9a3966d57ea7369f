#include "cirque/cones/curved_vertices.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/cones/cone_heuristic.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

double CurvatureOf(const Cone& cone) { return 2 * kPi - cone.lower; }

class CurvedVertices : public testing::TestWithParam<const char*> {
 protected:
  CurvedVertices()
      : surface_(GeneratedSurface(GetParam(), 900)),
        delaunay_(MakeIntrinsicDelaunay(surface_.triangulation, MeasureEdgeLengths(surface_))),
        problem_(delaunay_.triangulation, delaunay_.lengths) {}

  double AllCurvature() const { return problem_.curvature().lpNorm<1>(); }

  Surface surface_;
  IntrinsicTriangulation delaunay_;
  ConeProblem problem_;
};

TEST_P(CurvedVertices, AllOfThemKeepTheirOwnCurvature) {
  const std::vector<Cone> cones = ConesAtCurvedVertices(problem_, 1);
  double carried = 0;
  for (const Cone& cone : cones) {
    EXPECT_NEAR(CurvatureOf(cone), problem_.curvature()[cone.vertex], 1e-9);
    carried += std::abs(CurvatureOf(cone));
  }
  EXPECT_GT(carried, 1);
  EXPECT_NEAR(carried, AllCurvature(), 1e-9);
}

TEST_P(CurvedVertices, AShareOfThemAreTheMostCurvedAndKeepTheirScale) {
  const std::vector<Cone> cones = ConesAtCurvedVertices(problem_, 0.5);
  double carried = 0, least = 10, total = 0;
  std::vector<bool> is_cone(problem_.triangulation().num_vertices, false);
  for (const Cone& cone : cones) {
    const double own = std::abs(problem_.curvature()[cone.vertex]);
    carried += own;
    least = std::min(least, own);
    total += CurvatureOf(cone);
    is_cone[cone.vertex] = true;
  }
  EXPECT_GE(carried, 0.5 * AllCurvature());
  EXPECT_LT(carried - least, 0.5 * AllCurvature());
  for (const Index v : problem_.candidates()) {
    if (!is_cone[v]) {
      EXPECT_LE(std::abs(problem_.curvature()[v]), least);
    }
  }
  if (problem_.IsClosed()) {
    EXPECT_NEAR(total, problem_.TotalCurvature(), 1e-10);
  }
  const Eigen::VectorXd u = PredictedLogScale(problem_, cones);
  const double at_cones = problem_.IsClosed() ? u[cones.front().vertex] : 0;
  for (const Cone& cone : cones) EXPECT_NEAR(u[cone.vertex], at_cones, 1e-9);
}

TEST_P(CurvedVertices, UnfoldTheSurfaceWithoutDistortion) {
  ParameterizeOptions options;
  options.cones = "curvature_peaks:share=1";
  options.strict = true;
  Parameterization map;
  const Status status = Parameterize(surface_, {options}, {}, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_NEAR(map.certificate.distortion->quasi_conformal_max, 1, 1e-6);
  EXPECT_NEAR(map.certificate.distortion->log_area_ratio_l2, 0, 1e-7);
  EXPECT_EQ(map.certificate.layout->flipped_triangles, 0);
}

INSTANTIATE_TEST_SUITE_P(Generated, CurvedVertices,
                         testing::Values("blob", "torus", "double_torus", "bumpy_terrain"));

}  // namespace
}  // namespace cirque
