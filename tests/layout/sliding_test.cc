#include "cirque/layout/sliding.h"

#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/opened_map.h"
#include "cirque/layout/refine_map.h"
#include "cirque/layout/refine_patches.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr int kRim = 9;

/// A flat disk: a centre and two rings of vertices, the outer one on the unit circle at uneven
/// angles.
Surface FlatDisk() {
  std::vector<Eigen::Vector3d> points = {{0, 0, 0}};
  for (const double radius : {0.5, 1.0}) {
    for (int k = 0; k < kRim; ++k) {
      const double angle = 2 * kPi * (k + 0.2 * std::sin(3.0 * k)) / kRim;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
  }
  std::vector<std::array<Index, 3>> faces;
  for (Index k = 0; k < kRim; ++k) {
    const Index inner = 1 + k, next = 1 + (k + 1) % kRim;
    faces.push_back({0, inner, next});
    faces.push_back({inner, inner + kRim, next + kRim});
    faces.push_back({inner, next + kRim, next});
  }
  return *SurfaceFromTriangles(points, faces);
}

CornerUv UvOf(const Surface& flat, const std::vector<Complex>& z) {
  CornerUv uv;
  for (const Index v : flat.triangulation.vertex) uv.value.emplace_back(z[v].real(), z[v].imag());
  return uv;
}

std::vector<Complex> PlacesOf(const Surface& flat) {
  std::vector<Complex> z;
  for (const Eigen::Vector3d& p : flat.position) z.emplace_back(p.x(), p.y());
  return z;
}

std::vector<Complex> PlacesIn(const Surface& surface, const CornerUv& uv) {
  const Triangulation& t = surface.triangulation;
  std::vector<Complex> z(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    z[t.vertex[h]] = {uv.value[h].x(), uv.value[h].y()};
  }
  return z;
}

/// Sides of the strip [0, columns] x [0, rows] slide, corners are held.
struct Kept {
  std::vector<bool> held;
  SlidingVertices sliding;
};

Kept KeptOnRectangle(const Surface& strip, double columns, double rows) {
  const auto n = strip.position.size();
  Kept kept{std::vector<bool>(n, false),
            {std::vector<bool>(n, false), std::vector<Complex>(n, 1.0)}};
  for (std::size_t v = 0; v < n; ++v) {
    const double x = strip.position[v].x(), y = strip.position[v].y();
    const bool across = x == 0 || x == columns, along = y == 0 || y == rows;
    kept.held[v] = across && along;
    kept.sliding.slides[v] = across != along;
    if (along) kept.sliding.direction[v] = y == 0 ? 1.0 : -1.0;
    if (across) kept.sliding.direction[v] = Complex(0, x == 0 ? -1.0 : 1.0);
  }
  return kept;
}

StatusOr<MapRefinement> Refine(const Surface& surface, Kept kept, CornerUv* uv) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(t, lengths);
  const Cut none{std::vector<bool>(t.num_edges(), false)};
  return RefineMap({intrinsic, none, {}, std::move(kept.held), std::move(kept.sliding)},
                   *MapObjectives().Find("mips"), {.steps = 60, .decrease = 0}, nullptr, uv);
}

TEST(SlidingCholesky, IsTheLeastAmongStepsAlongTangents) {
  const Eigen::MatrixXcd root = Eigen::MatrixXcd::Random(6, 6);
  const Eigen::MatrixXcd dense = root.adjoint() * root + 0.1 * Eigen::MatrixXcd::Identity(6, 6);
  const Eigen::VectorXcd b = Eigen::VectorXcd::Random(6);
  const std::vector<Complex> tangents = {std::polar(1.0, 0.3), std::polar(1.0, 2.0)};
  SlidingCholesky cholesky({{1, 0}, {4, 0}}, 6);
  ASSERT_TRUE(cholesky.Factorize(
      ComplexSparseMatrix(dense.sparseView()).triangularView<Eigen::Lower>(), tangents));
  const Eigen::VectorXcd x = cholesky.Solve(b);
  EXPECT_NEAR(std::imag(std::conj(tangents[0]) * x[1]), 0, 1e-14);
  EXPECT_NEAR(std::imag(std::conj(tangents[1]) * x[4]), 0, 1e-14);
  // What is left of A x - b is normal to the rails, and nothing elsewhere.
  Eigen::VectorXcd left = dense * x - b;
  EXPECT_GT(std::abs(left[1]) + std::abs(left[4]), 1e-3);
  for (const auto& [v, tangent] : {std::pair(1, tangents[0]), std::pair(4, tangents[1])}) {
    EXPECT_NEAR(std::real(std::conj(tangent) * left[v]), 0, 1e-12);
    left[v] = 0;
  }
  EXPECT_LT(left.norm(), 1e-12);
}

TEST(Rail, KeepsToItsCurve) {
  const Complex z = std::polar(1.0, 0.7);
  EXPECT_NEAR(std::arg(Rail{0, 0}.Move(z, 0.5)), 1.2, 1e-15);
  EXPECT_NEAR(std::abs(Rail{0, 0}.Move(z, 2.9)), 1, 2e-16);
  EXPECT_EQ((Rail{0, -1.0}.Move({3, 0}, 1)), Complex(2, 0));
}

TEST(RimEdge, RunsOneWayOnly) {
  const RimEdge side{0, 1, Complex(0, 1)}, circle{0, 1, 0};
  EXPECT_TRUE(side.RunsBetween({0, 1}, {0, 2}));
  EXPECT_FALSE(side.RunsBetween({0, 1}, {0, 1}));
  EXPECT_TRUE(circle.RunsBetween(1, std::polar(1.0, 3.0)));
  EXPECT_FALSE(circle.RunsBetween(1, std::polar(1.0, 3.5)));
}

TEST(RefineMap, VerticesSlideBackAlongStraightSides) {
  // The flat rectangle itself is conformal: with corners held it is the only map of energy 0.
  const Surface strip = FlatStrip(8, 6);
  const std::vector<Complex> right = PlacesOf(strip);
  const Kept kept = KeptOnRectangle(strip, 8, 6);
  std::vector<Complex> moved = right;
  for (std::size_t v = 0; v < moved.size(); ++v) {
    const double by = 0.3 * std::sin(7.0 * static_cast<double>(v));
    if (kept.held[v]) continue;
    moved[v] += kept.sliding.slides[v] ? by * kept.sliding.direction[v] : std::polar(by, 0.1 * by);
  }
  CornerUv uv = UvOf(strip, moved);
  ASSERT_TRUE(FlippedFaces(strip.triangulation, uv).empty());
  const StatusOr<MapRefinement> done = Refine(strip, kept, &uv);
  ASSERT_TRUE(done.ok()) << done.status().message();
  EXPECT_GT(done->before, 0.02);
  EXPECT_LT(done->after, 1e-12);
  const std::vector<Complex> z = PlacesIn(strip, uv);
  for (std::size_t v = 0; v < z.size(); ++v) {
    EXPECT_LT(std::abs(z[v] - right[v]), 1e-6);
    if (strip.position[v].y() == 0) {
      EXPECT_EQ(z[v].imag(), 0);
    }
    if (strip.position[v].x() == 8) {
      EXPECT_EQ(z[v].real(), 8);
    }
  }
}

TEST(RefineMap, VerticesSlideBackAlongTheUnitCircle) {
  const Surface disk = FlatDisk();
  const std::vector<Complex> right = PlacesOf(disk);
  std::vector<Complex> moved = right;
  for (int k = 1; k < kRim; ++k) moved[1 + kRim + k] *= std::polar(1.0, 0.25 * std::cos(2.5 * k));
  Kept kept{std::vector<bool>(right.size(), false), {BoundaryVertices(disk.triangulation), {}}};
  kept.held[0] = kept.held[1 + kRim] = true;
  CornerUv uv = UvOf(disk, moved);
  ASSERT_TRUE(FlippedFaces(disk.triangulation, uv).empty());
  const StatusOr<MapRefinement> done = Refine(disk, kept, &uv);
  ASSERT_TRUE(done.ok()) << done.status().message();
  EXPECT_GT(done->before, 0.005);
  EXPECT_LT(done->after, 1e-12);
  const std::vector<Complex> z = PlacesIn(disk, uv);
  for (std::size_t v = 0; v < z.size(); ++v) EXPECT_LT(std::abs(z[v] - right[v]), 1e-6);
  for (int k = 0; k < kRim; ++k) EXPECT_NEAR(std::abs(z[1 + kRim + k]), 1, 3e-16);
  EXPECT_EQ(z[1 + kRim], right[1 + kRim]);
}

TEST(RefineByPatches, SlidesTheBoundaryOfAPatch) {
  // One vertex of the lower side is much too near to its neighbour.
  const Surface strip = FlatStrip(16, 8);
  std::vector<Complex> z = PlacesOf(strip);
  z[7] = 7.98;
  CornerUv uv = UvOf(strip, z);
  Kept kept = KeptOnRectangle(strip, 16, 8);
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const IntrinsicSurface surface = MeasureSurface(strip.triangulation, lengths);
  const Cut none{std::vector<bool>(strip.triangulation.num_edges(), false)};
  RefinePatchesOptions options;
  options.mean = options.once = 1e300;
  const auto done = RefineByPatches({surface, none, {}, std::move(kept.held), kept.sliding},
                                    options, nullptr, &uv);
  ASSERT_TRUE(done.ok()) << done.status().message();
  EXPECT_GE(done->patches, 1);
  EXPECT_EQ(done->steps, 0);
  EXPECT_LT(done->after, 1e-3 * done->before);
  const std::vector<Complex> after = PlacesIn(strip, uv);
  EXPECT_NEAR(after[7].real(), 7, 0.05);
  EXPECT_EQ(after[7].imag(), 0);
}

TEST(OpenedMap, VerticesThatDoNotLieAsTheBoundaryRunsStay) {
  const Surface strip = FlatStrip(4, 2);
  Kept kept = KeptOnRectangle(strip, 4, 2);
  kept.sliding.direction[2] = -1.0;  // the lower side runs the other way
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const IntrinsicSurface surface = MeasureSurface(strip.triangulation, lengths);
  const Cut none{std::vector<bool>(strip.triangulation.num_edges(), false)};
  OpenedMap map({surface, none, {}, kept.held, kept.sliding}, UvOf(strip, PlacesOf(strip)), 0);
  EXPECT_TRUE(map.held()[2]);
  EXPECT_FALSE(map.held()[1]);
  const MapPart part = map.Whole();
  EXPECT_EQ(part.rails.size(), 7u);  // of eight on the sides
}

}  // namespace
}  // namespace cirque
