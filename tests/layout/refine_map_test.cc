#include "cirque/layout/refine_map.h"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/beltrami_system.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

CornerUv UvOf(const Surface& flat) {
  CornerUv uv;
  for (const Index v : flat.triangulation.vertex) {
    uv.value.emplace_back(flat.position[v].x(), flat.position[v].y());
  }
  return uv;
}

/// The same corners with every vertex moved by up to `size` in both coordinates.
CornerUv Perturbed(const Triangulation& t, CornerUv uv, double size) {
  std::mt19937 random(3);
  std::vector<Eigen::Vector2d> move(t.num_vertices);
  for (Eigen::Vector2d& m : move) {
    const auto next = [&] {
      return size * (2.0 * random() / static_cast<double>(std::mt19937::max()) - 1);
    };
    m.x() = next();
    m.y() = next();
  }
  for (Index c = 0; c < t.num_halfedges(); ++c) uv.value[c] += move[t.vertex[c]];
  return uv;
}

Cut NoCut(const Triangulation& t) { return {std::vector<bool>(t.num_edges(), false)}; }

StatusOr<MapRefinement> Refine(const Surface& surface, const std::string& objective, int steps,
                               CornerUv* uv, const std::atomic<bool>* cancelled = nullptr) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  return RefineMap({MeasureSurface(t, lengths), NoCut(t), {}}, *MapObjectives().Find(objective),
                   {.steps = steps, .decrease = 0}, cancelled, uv);
}

double AreaOf(const CornerUv& uv) {
  double twice = 0;
  for (std::size_t c = 0; c < uv.value.size(); c += 3) {
    Eigen::Matrix2d edges;
    edges << uv.value[c + 1] - uv.value[c], uv.value[c + 2] - uv.value[c];
    twice += edges.determinant();
  }
  return twice / 2;
}

TEST(EveryMapObjective, TakesAPerturbedPlanarMeshBackToASimilarity) {
  const Surface strip = FlatStrip(8, 6);
  for (const std::string& name : MapObjectives().Names()) {
    SCOPED_TRACE(name);
    CornerUv uv = Perturbed(strip.triangulation, UvOf(strip), 0.15);
    const double area = AreaOf(uv);
    ASSERT_TRUE(FlippedFaces(strip.triangulation, uv).empty());
    const StatusOr<MapRefinement> done = Refine(strip, name, 60, &uv);
    ASSERT_TRUE(done.ok()) << done.status().message();
    EXPECT_GT(done->before, 0.04);
    EXPECT_LT(done->after, 1e-12);
    EXPECT_NEAR(AreaOf(uv), area, 1e-12 * area);
    // All angles are those of the surface again: 45 and 90 degrees.
    const Eigen::Vector2d a = uv.value[1] - uv.value[0], b = uv.value[2] - uv.value[0];
    const double ratio = a.norm() / b.norm();
    const Eigen::Vector3d x = strip.position[strip.triangulation.vertex[1]] -
                              strip.position[strip.triangulation.vertex[0]];
    const Eigen::Vector3d y = strip.position[strip.triangulation.vertex[2]] -
                              strip.position[strip.triangulation.vertex[0]];
    EXPECT_NEAR(ratio, x.norm() / y.norm(), 1e-6);
    EXPECT_NEAR(a.dot(b) / (a.norm() * b.norm()), x.dot(y) / (x.norm() * y.norm()), 1e-6);
  }
}

TEST(EveryMapObjective, GradientIsThatOfTheValue) {
  const Surface terrain = GeneratedSurface("bumpy_terrain", 200);
  const Triangulation& t = terrain.triangulation;
  const CornerAngles angles = AnglesOf(terrain);
  const EdgeLengths lengths = MeasureEdgeLengths(terrain);
  Eigen::VectorXcd z(t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) {
    z[v] = {terrain.position[v].x(), terrain.position[v].y()};
  }
  const Eigen::VectorXcd direction = Eigen::VectorXcd::Random(t.num_vertices);
  for (const std::string& name : MapObjectives().Names()) {
    SCOPED_TRACE(name);
    const MapObjective objective = *MapObjectives().Find(name);
    BeltramiSystem system(t, t, angles, lengths, {}, objective);
    system.Linearize(z);
    const double step = 1e-7;
    const double slope =
        (system.Value(z + step * direction) - system.Value(z - step * direction)) / (2 * step);
    ASSERT_GT(std::abs(slope), 1e-3);
    EXPECT_NEAR(system.gradient().dot(direction).real(), slope, 1e-6 * std::abs(slope));
  }
}

TEST(RefineMap, LeavesAConformalMapAlone) {
  const Surface strip = FlatStrip(4, 4);
  CornerUv uv = UvOf(strip);
  const StatusOr<MapRefinement> done = Refine(strip, "mips", 5, &uv);
  ASSERT_TRUE(done.ok());
  EXPECT_LT(done->before, 1e-28);
  for (std::size_t c = 0; c < uv.value.size(); ++c) {
    EXPECT_LT((uv.value[c] - UvOf(strip).value[c]).norm(), 1e-14);
  }
}

TEST(RefineMap, AFaceWithoutAreaKeepsItsOrientation) {
  // A vertex of the surface lies on an edge; in the plane its triangle has an area.
  Surface strip = FlatStrip(4, 4);
  const CornerUv start = Perturbed(strip.triangulation, UvOf(strip), 0.1);
  const Index* corner = &strip.triangulation.vertex[0];
  strip.position[corner[0]] = 0.5 * (strip.position[corner[1]] + strip.position[corner[2]]);
  CornerUv uv = start;
  const StatusOr<MapRefinement> done = Refine(strip, "mips", 20, &uv);
  ASSERT_TRUE(done.ok());
  EXPECT_LT(done->after, done->before);
  EXPECT_TRUE(FlippedFaces(strip.triangulation, uv).empty());
}

TEST(RefineMap, EndsWhenCancelledAndLeavesTheMap) {
  const Surface strip = FlatStrip(4, 4);
  const CornerUv start = Perturbed(strip.triangulation, UvOf(strip), 0.1);
  CornerUv uv = start;
  const std::atomic<bool> cancelled = true;
  EXPECT_EQ(Refine(strip, "mips", 5, &uv, &cancelled).status().code(), StatusCode::kCancelled);
  EXPECT_EQ(uv.value, start.value);
}

}  // namespace
}  // namespace cirque
