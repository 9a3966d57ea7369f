// Overlays through a Delaunay triangulation: points on a circle, where all is straight; flips alone;
// and a Moebius map, whose projective maps are drawn by circles and chords.
#include "cirque/intrinsic/broken_geodesics.h"

#include <cmath>
#include <complex>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "cirque/intrinsic/flip_complex.h"
#include "cirque/intrinsic/straight_lines.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr std::int64_t kNoBound = std::numeric_limits<std::int64_t>::max();

/// A triangulation flipped at random in its own metric, where a flip is no sliver's.
IntrinsicTriangulation FlipAtRandom(const Triangulation& t, const EdgeLengths& lengths,
                                    int attempts, unsigned seed) {
  FlipComplex complex(t, lengths);
  std::mt19937 random(seed);
  IntrinsicTriangulation result;
  for (int i = 0; i < attempts; ++i) {
    const Index h = static_cast<Index>(random() % t.vertex.size()), g = complex.twin(h);
    if (g == kNone || h / 3 == g / 3) continue;
    const auto length = complex.OtherDiagonal(h);
    if (!length) continue;
    complex.Flip(h, *length, kNone);
    result.flips.push_back(h);
  }
  result.triangulation = complex.MakeTriangulation(t.num_vertices);
  result.lengths = complex.MakeLengths(result.triangulation);
  return result;
}

void ExpectSamePositions(const Overlay& a, const Overlay& b, double tolerance) {
  ASSERT_EQ(a.crossing.size(), b.crossing.size());
  ASSERT_EQ(a.corner.size(), b.corner.size());
  for (std::size_t i = 0; i < a.crossing.size(); ++i) {
    EXPECT_EQ(a.crossing[i].input, b.crossing[i].input);
    EXPECT_EQ(a.crossing[i].other, b.crossing[i].other);
    EXPECT_NEAR(a.crossing[i].along_input, b.crossing[i].along_input, tolerance);
    EXPECT_NEAR(a.crossing[i].along_other, b.crossing[i].along_other, tolerance);
  }
}

Overlay Straight(const Triangulation& input, const IntrinsicTriangulation& to) {
  return *MakeOverlay(input, to.flips, StraightLines(to.triangulation, to.lengths), kNoBound);
}

TEST(OverlayThroughDelaunay, OfPointsOnACircleAllChordsAreStraight) {
  // Whatever flips are called the metric's own: on one circle Ptolemy's are the same.
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < 14; ++i) {
    const double at = 0.4 * i + 0.15 * std::sin(3.0 * i);
    points.emplace_back(std::cos(at), std::sin(at), 0);
    if (i > 1) triangles.push_back({0, i - 1, i});
  }
  const Surface surface = *SurfaceFromTriangles(points, triangles);
  const Triangulation& t = surface.triangulation;
  for (unsigned seed = 1; seed < 6; ++seed) {
    ScaledTriangulation of{t, FlipAtRandom(t, MeasureEdgeLengths(surface), 40, seed), {}, {}};
    of.scaled = FlipAtRandom(of.delaunay.triangulation, of.delaunay.lengths, 40, seed + 10);
    ASSERT_GT(of.scaled.flips.size(), 5u);
    of.scaled.flips.insert(of.scaled.flips.begin(), of.delaunay.flips.begin(),
                           of.delaunay.flips.end());
    of.log_scale = Eigen::VectorXd::Zero(t.num_vertices);
    const auto through = OverlayThroughDelaunay(of, kNoBound);
    ASSERT_TRUE(through.ok());
    const Overlay straight = Straight(t, of.scaled);
    ASSERT_GT(straight.crossing.size(), 10u);
    ExpectSamePositions(*through, straight, 1e-8);
  }
}

/// A flat patch of long triangles, and its Delaunay triangulation.
struct ShearedPatch {
  Surface surface = Moved(GeneratedSurface("flat_delaunay_patch", 200),
                          [](auto x) { return Eigen::Vector3d(x.x() + 1.5 * x.y(), x.y(), 0); });
  IntrinsicTriangulation delaunay =
      MakeIntrinsicDelaunay(surface.triangulation, MeasureEdgeLengths(surface));

  Complex At(Index v) const { return {surface.position[v].x(), surface.position[v].y()}; }
};

TEST(OverlayThroughDelaunay, WithoutScalesItIsTheMetricsOwn) {
  const ShearedPatch patch;
  const Triangulation& t = patch.surface.triangulation;
  const ScaledTriangulation of{t, patch.delaunay, patch.delaunay,
                               Eigen::VectorXd::Zero(t.num_vertices)};
  const auto through = OverlayThroughDelaunay(of, kNoBound);
  ASSERT_TRUE(through.ok());
  ASSERT_GT(through->crossing.size(), 50u);
  ExpectSamePositions(*through, Straight(t, patch.delaunay), 1e-10);
}

Complex MoebiusMap(Complex z) { return (2.0 * z + Complex(0.3, 1)) / (0.35 * z - Complex(0, 2.1)); }
double MoebiusScale(Complex z) {
  const Complex determinant = 2.0 * -Complex(0, 2.1) - Complex(0.3, 1) * 0.35;
  return std::abs(determinant) / std::norm(0.35 * z - Complex(0, 2.1));
}

double Cross(Complex a, Complex b) { return (std::conj(a) * b).imag(); }

/// Where the line from c through p meets the circle through a, b and c again.
Complex OnCircle(Complex a, Complex b, Complex c, Complex p) {
  const Complex u = a - c, v = b - c;
  const double area = 2 * Cross(u, v);
  const Complex centre = Complex(0, 1) * (std::norm(v) * u - std::norm(u) * v) / area;
  const Complex way = (p - c) / std::abs(p - c);
  return c + 2 * (std::conj(way) * centre).real() * way;
}

TEST(OverlayThroughDelaunay, OfAMoebiusMapItIsTheProjectiveMapOfEveryCircle) {
  const ShearedPatch patch;
  const Triangulation &t = patch.surface.triangulation, &other = patch.delaunay.triangulation;
  ScaledTriangulation of{t, patch.delaunay, patch.delaunay, Eigen::VectorXd(t.num_vertices)};
  const auto image = [&](Index v) { return MoebiusMap(patch.At(v)); };
  for (Index v = 0; v < t.num_vertices; ++v) of.log_scale[v] = std::log(MoebiusScale(patch.At(v)));
  ASSERT_GT(of.log_scale.maxCoeff() - of.log_scale.minCoeff(), 0.5);
  for (Index e = 0; e < other.num_edges(); ++e) {
    const Index h = other.edge_halfedge[e];
    const double scale = std::exp(0.5 * (of.log_scale[other.Tail(h)] + of.log_scale[other.Tip(h)]));
    of.scaled.lengths.value[e] = scale * patch.delaunay.lengths.value[e];
    EXPECT_NEAR(of.scaled.lengths.value[e], std::abs(image(other.Tail(h)) - image(other.Tip(h))),
                1e-12);
  }
  const Overlay through = *OverlayThroughDelaunay(of, kNoBound);
  const Overlay straight = Straight(t, patch.delaunay);
  ASSERT_EQ(through.crossing.size(), straight.crossing.size());
  for (std::size_t i = 0; i < through.crossing.size(); ++i) {
    EXPECT_NEAR(through.crossing[i].along_input, straight.crossing[i].along_input, 1e-10);
    const Index h = through.crossing[i].other;
    const Index va = other.Tail(h), vb = other.Tip(h), vc = other.vertex[h];
    const Complex a = patch.At(va), b = patch.At(vb), c = patch.At(vc);
    const Complex p = a + straight.crossing[i].along_other * (b - a);
    const Complex q = MoebiusMap(OnCircle(a, b, c, p));
    const Complex a2 = image(va), b2 = image(vb), c2 = image(vc);
    const double along = Cross(q - c2, c2 - a2) / Cross(q - c2, b2 - a2);
    EXPECT_NEAR(through.crossing[i].along_other, along, 1e-9);
  }
}

}  // namespace
}  // namespace cirque
