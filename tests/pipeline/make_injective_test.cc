#include "cirque/pipeline/make_injective.h"

#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

/// A flat strip that goes round by so many turns, like a spiral stair's: unrolled it lies upon itself.
Surface Stair(double turns) {
  const Surface strip = FlatStrip(80, 4);
  return Moved(strip, [&](const Eigen::Vector3d& x) {
    const double angle = 2 * kPi * turns * (1 - x.x() / 80), radius = 1 + 0.15 * x.y();
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.02 * angle);
  });
}

Parameterization MapOf(const Surface& surface, ParameterizeOptions options) {
  Parameterization map;
  const Status status = Parameterize(surface, {options}, {}, &map);
  EXPECT_TRUE(status.ok()) << status.message();
  return map;
}

bool Overlaps(const Surface& surface, const Parameterization& map) {
  return OverlapsItself(CutOpen(surface.triangulation, map.cut), map.uv);
}

TEST(MakeInjective, LeavesAnInjectiveImageAlone) {
  const Surface cap = GeneratedSurface("hemisphere", 200);
  ParameterizeOptions options;
  const Parameterization plain = MapOf(cap, options);
  options.injective = true;
  const Parameterization map = MapOf(cap, options);
  EXPECT_EQ(map.uv.value, plain.uv.value);
  EXPECT_FALSE(map.certificate.injectivity.has_value());
}

TEST(MakeInjective, TurnsTheBoundaryOfADiskWithoutASeam) {
  const Surface stair = Stair(1.4);
  ParameterizeOptions options;
  const Parameterization plain = MapOf(stair, options);
  ASSERT_TRUE(Overlaps(stair, plain));
  EXPECT_EQ(plain.certificate.overlap, "boundary_overlaps");
  options.injective = true;
  const Parameterization map = MapOf(stair, options);
  EXPECT_FALSE(Overlaps(stair, map));
  EXPECT_EQ(map.certificate.overlap, "injective");
  ASSERT_TRUE(map.certificate.injectivity.has_value());
  EXPECT_EQ(map.certificate.injectivity->made_by, "curvature");
  EXPECT_GT(*map.certificate.injectivity->boundary_turned, 0.01);
  EXPECT_TRUE(map.cut.IsEmpty());
  EXPECT_TRUE(FlippedFaces(stair.triangulation, map.uv).empty());
  // Angles are kept, areas pay.
  EXPECT_LT(map.certificate.distortion->quasi_conformal_mean, 1.1);
  EXPECT_GT(map.certificate.distortion->log_area_ratio_l2,
            plain.certificate.distortion->log_area_ratio_l2);
}

/// A closed surface whose image overlaps itself as it comes: that map, and the injective one.
std::pair<Parameterization, Parameterization> MapsOfDoubleTorus(SeamKind seams) {
  const Surface torus = GeneratedSurface("double_torus", 1200);
  ParameterizeOptions options;
  options.cones = "greedy:cones=12";
  options.seams = seams;
  Parameterization plain = MapOf(torus, options);
  EXPECT_TRUE(Overlaps(torus, plain));
  options.injective = true;
  Parameterization map = MapOf(torus, options);
  EXPECT_FALSE(Overlaps(torus, map));
  EXPECT_EQ(map.certificate.overlap, "injective");
  return {std::move(plain), std::move(map)};
}

TEST(MakeInjective, DescendsWhereThereIsNoBoundaryToTurn) {
  const auto [plain, map] = MapsOfDoubleTorus(SeamKind::kAuto);
  const InjectivitySummary& injectivity = *map.certificate.injectivity;
  EXPECT_EQ(injectivity.made_by, "descent");
  EXPECT_LT(*injectivity.descent_after, *injectivity.descent_before);
  // One chart along the same cut, its seams free: they have no motions to tell of.
  EXPECT_EQ(map.cut.edge, plain.cut.edge);
  EXPECT_EQ(map.certificate.layout->patches, 1);
  EXPECT_EQ(map.certificate.seams->seams, 0);
  EXPECT_TRUE(map.certificate.message.empty()) << map.certificate.message;
  EXPECT_LT(map.certificate.distortion->quasi_conformal_mean,
            plain.certificate.distortion->quasi_conformal_mean + 0.05);
}

TEST(MakeInjective, CutsIntoChartsWhereSeamsAreToMatch) {
  const auto [plain, map] = MapsOfDoubleTorus(SeamKind::kRigid);
  const InjectivitySummary& injectivity = *map.certificate.injectivity;
  EXPECT_EQ(injectivity.made_by, "charts");
  EXPECT_GE(injectivity.charts, 2);
  EXPECT_LE(injectivity.charts, 8);
  EXPECT_EQ(map.certificate.layout->patches, injectivity.charts);
  EXPECT_GT(*map.certificate.layout->cut_length, *plain.certificate.layout->cut_length);
  // The metric is as it was.
  EXPECT_NEAR(map.certificate.distortion->quasi_conformal_mean,
              plain.certificate.distortion->quasi_conformal_mean, 1e-9);
}

TEST(MakeInjective, OpensFreeSeamsAndMakesTheDiskInjective) {
  const Surface torus = GeneratedSurface("double_torus", 1200);
  ParameterizeOptions options;
  options.cones = "greedy:cones=12";
  options.seams = SeamKind::kFree;
  options.injective = true;
  const Parameterization map = MapOf(torus, options);
  EXPECT_FALSE(Overlaps(torus, map));
  EXPECT_EQ(map.certificate.overlap, "injective");
}

TEST(MakeInjective, KeepsABoundaryThatIsPrescribed) {
  const Surface stair = Stair(1.4);
  const Parameterization plain = MapOf(stair, {});
  ParameterizeRequest request;
  request.options.injective = true;
  request.targets = FreeBoundaryTargets(stair.triangulation);
  const std::vector<double> sum = VertexAngleSums(stair.triangulation, plain.flat.on_input.angles);
  const std::vector<bool> boundary = BoundaryVertices(stair.triangulation);
  for (Index v = 0; v < stair.triangulation.num_vertices; ++v) {
    if (boundary[v]) request.targets->lower[v] = request.targets->upper[v] = sum[v];
  }
  Parameterization map;
  ASSERT_TRUE(Parameterize(stair, request, {}, &map).ok());
  EXPECT_EQ(map.certificate.injectivity->made_by, "charts");
  EXPECT_EQ(map.certificate.injectivity->charts, 2);
}

TEST(MakeInjective, AndAnExactMapAreNotToBeHadTogether) {
  ParameterizeRequest request;
  request.options.injective = request.options.exact = true;
  Parameterization map;
  const Status status = Parameterize(GeneratedSurface("hemisphere", 100), request, {}, &map);
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr("leave out exact or injective"));
}

}  // namespace
}  // namespace cirque
