#include "cirque/remesh/curvature_density.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/remesh/remesh_surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

constexpr double kAxis = 3;

/// The spheroid of axes 1, 1 and kAxis.
Surface Spheroid(Index triangles) {
  return Moved(GeneratedSurface("sphere", triangles), [](const Eigen::Vector3d& x) {
    const Eigen::Vector3d n = x.normalized();
    return Eigen::Vector3d(n.x(), n.y(), kAxis * n.z());
  });
}

/// The root of k1^2 + k2^2 there: of the meridian and of the parallel.
double CurvatureAt(const Eigen::Vector3d& x) {
  const double sine = std::clamp(x.z() / kAxis, -1., 1.);
  const double w = std::sqrt(sine * sine + kAxis * kAxis * (1 - sine * sine));
  return std::hypot(kAxis / (w * w * w), kAxis / w);
}

RemeshedSurface Remeshed(const Surface& surface, const Eigen::VectorXd& density) {
  MapRequest request;
  request.options.exact = true;
  request.options.refine_map = "none";
  const StatusOr<SurfaceMap> map = MapSurface(surface, request);
  EXPECT_TRUE(map.ok()) << map.status().message();
  RemeshOptions options;
  options.vertices = 1000;
  options.density = density;
  const StatusOr<RemeshedSurface> made = RemeshSurface(surface, *map, options);
  EXPECT_TRUE(made.ok()) << made.status().message();
  EXPECT_NEAR(made->triangulation.num_vertices, 1000, 25);
  return *made;
}

/// Of the logarithms of edges' lengths, each with weight(middle) added: mean and deviation.
template <class Weight>
std::pair<double, double> LogLengths(const RemeshedSurface& made, const Weight& weight) {
  const Triangulation& t = made.triangulation;
  double sum = 0, squares = 0;
  for (const Index h : t.edge_halfedge) {
    const Eigen::Vector3d &a = made.position[t.Tail(h)], &b = made.position[t.Tip(h)];
    const double value = std::log((b - a).norm()) + weight((a + b) / 2);
    sum += value;
    squares += value * value;
  }
  const double n = t.num_edges(), mean = sum / n;
  return {mean, std::sqrt(squares / n - mean * mean)};
}

TEST(DensityByCurvature, FollowsTheCurvatureOfASpheroid) {
  const Surface surface = Spheroid(8000);
  const Eigen::VectorXd density = DensityByCurvature(surface, {1, 100, 0.01});
  // Lengths are as 1 / k: density times the square of that is the same everywhere.
  double sum = 0, squares = 0;
  for (Index v = 0; v < density.size(); ++v) {
    const double value = std::log(density[v]) / 2 - std::log(CurvatureAt(surface.position[v]));
    sum += value;
    squares += value * value;
  }
  const double n = static_cast<double>(density.size());
  EXPECT_LT(std::sqrt(squares / n - sum * sum / (n * n)), 0.05);
  EXPECT_GT(density.maxCoeff() / density.minCoeff(), 9);  // 16 between a pole and the equator
}

TEST(DensityByCurvature, RemeshedEdgesAreAsLongAsTheRadiusOfCurvature) {
  const Surface surface = Spheroid(4000);
  const RemeshedSurface by_curvature = Remeshed(surface, DensityByCurvature(surface, {})),
                        even = Remeshed(surface, {});
  const auto log_curvature = [](const Eigen::Vector3d& x) { return std::log(CurvatureAt(x)); };
  EXPECT_LT(LogLengths(by_curvature, log_curvature).second,
            0.6 * LogLengths(even, log_curvature).second);
  EXPECT_LT(LogLengths(by_curvature, log_curvature).second, 0.2);
}

TEST(DensityByCurvature, IsEvenOnASphereAndOneWhereThereIsNoCurvature) {
  const Surface sphere = GeneratedSurface("sphere", 4000);
  const Eigen::VectorXd density = DensityByCurvature(sphere, {});
  EXPECT_LT(density.maxCoeff() / density.minCoeff(), 1.25);
  const auto nothing = [](const Eigen::Vector3d&) { return 0.; };
  EXPECT_NEAR(LogLengths(Remeshed(sphere, density), nothing).second,
              LogLengths(Remeshed(sphere, {}), nothing).second, 0.03);
  EXPECT_EQ(DensityByCurvature(FlatStrip(6, 4), {}), Eigen::VectorXd::Ones(35));
}

TEST(DensityByCurvature, IsBoundedAndKnowsNoUnits) {
  const Surface surface = Spheroid(2000);
  const Eigen::VectorXd density = DensityByCurvature(surface, {2, 3, 0.02});
  EXPECT_LE(density.maxCoeff() / density.minCoeff(), 9 * (1 + 1e-12));
  EXPECT_GT(density.maxCoeff() / density.minCoeff(), 8.5);
  const Surface larger = Moved(surface, [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(1000 * x.z() + 5, 1000 * x.x(), 1000 * x.y());
  });
  EXPECT_LT((DensityByCurvature(larger, {2, 3, 0.02}) - density).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_EQ(DensityByCurvature(surface, {2, 3, 0.02}), density);
  EXPECT_LT((DensityByCurvature(surface, {0, 3, 0.02}).array() - 1).abs().maxCoeff(), 1e-14);
}

TEST(CurvatureSizing, IsReadWithItsOptions) {
  EXPECT_TRUE(NamesCurvatureSizing("curvature") && NamesCurvatureSizing("curvature:ratio=2"));
  EXPECT_FALSE(NamesCurvatureSizing("./curvature") || NamesCurvatureSizing("curvatures.txt"));
  EXPECT_EQ(ParseCurvatureSizing("curvature:strength=0.5,ratio=4")->strength, 0.5);
  EXPECT_EQ(ParseCurvatureSizing("curvature:strength=0.5,ratio=4")->ratio, 4);
  EXPECT_THAT(ParseCurvatureSizing("curvature:ratio=0.5").status().message(), HasSubstr("ratio"));
  EXPECT_THAT(ParseCurvatureSizing("curvature:rato=2").status().message(), HasSubstr("'ratio'"));
}

}  // namespace
}  // namespace cirque
