#include "cirque/cuts/part_into_charts.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

Cut NoCut(const Triangulation& t) { return {std::vector<bool>(t.num_edges(), false)}; }

Index PatchesOf(const Triangulation& t, const Cut& cut) {
  return ConnectedPatches(CutOpen(t, cut)).count;
}

double LengthOf(const Cut& cut, const Eigen::VectorXd& lengths) {
  double sum = 0;
  for (Index e = 0; e < lengths.size(); ++e) sum += cut.edge[e] ? lengths[e] : 0;
  return sum;
}

StatusOr<Cut> Part(const Surface& surface, Index count) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  return PartIntoCharts(MeasureSurface(surface.triangulation, lengths), lengths.value,
                        NoCut(surface.triangulation), count);
}

/// A closed surface of revolution about z: rings of 24 vertices of these radii, one unit apart, and
/// a vertex beyond either end.
Surface Turned(const std::vector<double>& radii) {
  constexpr Index kSides = 24;
  const auto rings = static_cast<Index>(radii.size());
  PolygonSoup soup;
  for (Index r = 0; r < rings; ++r) {
    for (Index i = 0; i < kSides; ++i) {
      const double phi = 2 * kPi * i / kSides;
      soup.position.emplace_back(radii[r] * std::cos(phi), radii[r] * std::sin(phi), r);
    }
  }
  soup.position.emplace_back(0, 0, -1);
  soup.position.emplace_back(0, 0, rings);
  const auto add = [&](Index a, Index b, Index c) {
    soup.corner.insert(soup.corner.end(), {a, b, c});
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  };
  for (Index i = 0; i < kSides; ++i) {
    const Index j = (i + 1) % kSides, last = (rings - 1) * kSides;
    add(j, i, rings * kSides);
    add(last + i, last + j, rings * kSides + 1);
    for (Index r = 0; r + 1 < rings; ++r) {
      const Index low = r * kSides, high = low + kSides;
      add(low + i, low + j, high + j), add(low + i, high + j, high + i);
    }
  }
  return SurfaceOf(soup);
}

TEST(PartIntoCharts, GivesAsManyConnectedPatchesAsAreAskedForAndTheSameAgain) {
  for (const char* generator : {"blob", "torus", "double_torus", "bumpy_terrain", "annulus"}) {
    const Surface surface = GeneratedSurface(generator, 1000);
    for (const Index count : {1, 2, 3, 7, 20}) {
      const StatusOr<Cut> cut = Part(surface, count);
      ASSERT_TRUE(cut.ok()) << cut.status().message();
      EXPECT_EQ(PatchesOf(surface.triangulation, *cut), count) << generator;
      EXPECT_EQ(Part(surface, count)->edge, cut->edge);
    }
  }
}

// The neck of a dumbbell, not in the middle, is the shortest loop that parts much from much.
TEST(PartIntoCharts, FindsTheNeck) {
  const Surface dumbbell =
      Turned({1, 2, 2.5, 2.5, 2, 1, 0.6, 0.3, 0.6, 1, 2, 3, 3.5, 3.5, 3, 2, 1});
  const StatusOr<Cut> cut = Part(dumbbell, 2);
  ASSERT_TRUE(cut.ok());
  const double neck = 24 * 2 * 0.3 * std::sin(kPi / 24);
  EXPECT_NEAR(LengthOf(*cut, MeasureEdgeLengths(dumbbell).value), neck, 1e-12);
  EXPECT_EQ(PatchesOf(dumbbell.triangulation, *cut), 2);
}

TEST(PartIntoCharts, CutsALongTubeAcross) {
  const Surface tube = Turned(std::vector<double>(60, 1.0));
  const double circle = 24 * 2 * std::sin(kPi / 24);
  for (const Index count : {2, 3, 5}) {
    const StatusOr<Cut> cut = Part(tube, count);
    ASSERT_TRUE(cut.ok());
    EXPECT_NEAR(LengthOf(*cut, MeasureEdgeLengths(tube).value),
                static_cast<double>(count - 1) * circle, 1e-9);
  }
}

// Halves of a sphere: edges of a mesh lead round it on no shorter way than a great circle, and on one
// little longer.
TEST(PartIntoCharts, HalvesASphereAlongAGreatCircle) {
  const Surface sphere = GeneratedSurface("sphere", 3000);
  const StatusOr<Cut> cut = Part(sphere, 2);
  ASSERT_TRUE(cut.ok());
  const double length = LengthOf(*cut, MeasureEdgeLengths(sphere).value);
  EXPECT_GT(length, 0.9 * 2 * kPi);
  EXPECT_LT(length, 1.1 * 2 * kPi);
}

// What is two handles comes apart where it is thinnest between them: no longer than the loop of edges
// nearest to the plane between the two.
TEST(PartIntoCharts, ADoubleTorusComesApartBetweenItsHandles) {
  const Surface surface = GeneratedSurface("double_torus", 3000);
  const Triangulation& t = surface.triangulation;
  const StatusOr<Cut> cut = Part(surface, 2);
  ASSERT_TRUE(cut.ok());
  const Triangulation open = CutOpen(t, *cut);
  // Two patches of genus 1 with one loop each, chi = -1 both.
  EXPECT_EQ(ConnectedPatches(open).count, 2);
  EXPECT_EQ(BoundaryLoops(open).size(), 2u);
  EXPECT_EQ(EulerCharacteristic(open), -2);
}

TEST(PartIntoCharts, ClosedEdgesAndGivenCutsStayAsTheyAre) {
  const Surface surface = GeneratedSurface("torus", 1000);
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  Eigen::VectorXd costs = lengths.value;
  // Pairs of faces held together, as halves of quadrilaterals are.
  std::vector<bool> taken(t.num_faces(), false);
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const Index a = Triangulation::Face(h), b = Triangulation::Face(t.twin[h]);
    if (taken[a] || taken[b]) continue;
    taken[a] = taken[b] = true;
    costs[e] = std::numeric_limits<double>::infinity();
  }
  const Cut given = *CutGraph(t, lengths.value, {});
  const auto cut = PartIntoCharts(MeasureSurface(t, lengths), costs, given, 5);
  ASSERT_TRUE(cut.ok());
  EXPECT_EQ(PatchesOf(t, *cut), 5);
  for (Index e = 0; e < t.num_edges(); ++e) {
    EXPECT_TRUE(cut->edge[e] || !given.edge[e]);
    EXPECT_FALSE(cut->edge[e] && !given.edge[e] && !std::isfinite(costs[e]));
  }
  EXPECT_EQ(PartIntoCharts(MeasureSurface(t, lengths), costs, *cut, 4)->edge, cut->edge);
}

TEST(PartIntoCharts, RefusesWhatCannotBeAndStopsWhenCancelled) {
  const Surface body = RegularPolyhedron(8);
  EXPECT_EQ(PatchesOf(body.triangulation, *Part(body, 8)), 8);
  EXPECT_THAT(Part(body, 9).status().message(), HasSubstr("the surface has only 8 faces"));
  const EdgeLengths lengths = MeasureEdgeLengths(body);
  const std::atomic<bool> cancelled = true;
  const auto cut = PartIntoCharts(MeasureSurface(body.triangulation, lengths), lengths.value,
                                  NoCut(body.triangulation), 2, &cancelled);
  EXPECT_EQ(cut.status().code(), StatusCode::kCancelled);
}

/// The area of every patch of an image, over that on the surface.
std::vector<double> ScalesOf(const Surface& surface, const Parameterization& map) {
  const Triangulation& t = surface.triangulation;
  const Patches patches = ConnectedPatches(CutOpen(t, map.cut));
  std::vector<double> image(patches.count, 0), own(patches.count, 0);
  for (Index f = 0; f < t.num_faces(); ++f) {
    const auto uv = map.uv.value.begin() + 3 * f;
    const Eigen::Vector2d a = uv[1] - uv[0], b = uv[2] - uv[0];
    image[patches.of_face[f]] += 0.5 * (a.x() * b.y() - a.y() * b.x());
    const auto at = [&](Index k) { return surface.position[t.vertex[3 * f + k]]; };
    own[patches.of_face[f]] += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  for (Index p = 0; p < patches.count; ++p) image[p] /= own[p];
  return image;
}

TEST(LeastCharts, EveryChartIsADiskWhateverTheSeams) {
  for (const char* generator : {"sphere", "torus", "double_torus", "bumpy_terrain", "annulus"}) {
    const Surface surface = GeneratedSurface(generator, 1200);
    const Triangulation& t = surface.triangulation;
    for (const SeamKind seams : {SeamKind::kAuto, SeamKind::kRigid, SeamKind::kFree}) {
      SCOPED_TRACE(std::string(generator) + " " + ToWord(seams));
      ParameterizeOptions options;
      options.least_charts = 6;
      options.seams = seams;
      Parameterization map;
      const Status status = Parameterize(surface, {options}, {}, &map);
      ASSERT_TRUE(status.ok()) << status.message();
      EXPECT_TRUE(CheckCut(t, map.cut, {}).ok());
      EXPECT_EQ(PatchesOf(t, map.cut), 6);
      EXPECT_EQ(*map.certificate.layout->patches, 6);
      EXPECT_EQ(map.certificate.layout->flipped_triangles, 0);
      EXPECT_LT(map.certificate.distortion->quasi_conformal_mean, 1.2);
      // Opened first, every chart is flat by itself, and keeps its size.
      const std::vector<double> scale = ScalesOf(surface, map);
      const auto [least, greatest] = std::minmax_element(scale.begin(), scale.end());
      if (seams != SeamKind::kRigid) {
        EXPECT_LT(*greatest / *least, 1.3);
      }
    }
  }
}

TEST(LeastCharts, DoesNotGoWithAnExactMapOrALattice) {
  const Surface surface = GeneratedSurface("torus", 400);
  ParameterizeRequest request;
  request.options.least_charts = 3;
  request.options.exact = true;
  Parameterization map;
  EXPECT_THAT(Parameterize(surface, request, {}, &map).message(),
              HasSubstr("leave out exact or least_charts"));
  request.options.exact = false;
  request.options.holonomy = HolonomyRule::kHalves;
  request.options.integer_cells = 100;
  EXPECT_THAT(Parameterize(surface, request, {}, &map).message(),
              HasSubstr("leave out least_charts"));
  request.options = {};
  request.options.least_charts = 401;
  EXPECT_THAT(Parameterize(surface, request, {}, &map).message(),
              HasSubstr("least_charts: 401 charts were asked for"));
}

}  // namespace
}  // namespace cirque
