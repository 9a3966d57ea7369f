// Overlays after random flips: crossings counted by exact predicates in the plane, faces of the
// same shape in both triangulations, also where faces are glued to themselves.
#include "cirque/intrinsic/overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "cirque/intrinsic/flip_complex.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/intrinsic/normal_coordinates.h"
#include "cirque/intrinsic/straight_lines.h"
#include "cirque/math/predicates.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

constexpr std::int64_t kNoBound = std::numeric_limits<std::int64_t>::max();

struct Flipped {
  std::vector<Index> flips;
  Triangulation triangulation;
  EdgeLengths lengths;
};

/// Flips edges at random where the two faces unfold to a convex quadrilateral that is no sliver.
Flipped FlipAtRandom(const Triangulation& t, const EdgeLengths& lengths, int attempts,
                     unsigned seed) {
  FlipComplex complex(t, lengths);
  std::mt19937 random(seed);
  Flipped result;
  for (int i = 0; i < attempts; ++i) {
    const Index h = static_cast<Index>(random() % t.vertex.size()), g = complex.twin(h);
    if (g == kNone || h / 3 == g / 3) continue;
    const auto length = complex.OtherDiagonal(h);
    if (!length || complex.RatioAfterFlip(h, *length) > 1e4) continue;
    complex.Flip(h, *length, kNone);
    result.flips.push_back(h);
  }
  result.triangulation = complex.MakeTriangulation(t.num_vertices);
  result.lengths = complex.MakeLengths(result.triangulation);
  return result;
}

Overlay OverlayOf(const Triangulation& t, const Flipped& flipped) {
  const auto overlay = MakeOverlay(t, flipped.flips,
                                   StraightLines(flipped.triangulation, flipped.lengths), kNoBound);
  EXPECT_TRUE(overlay.ok()) << overlay.status().message();
  return *overlay;
}

/// The corners of every face in the plane, by lengths.
std::vector<Eigen::Vector2d> FacesInPlane(const Triangulation& t, const EdgeLengths& lengths) {
  const CornerAngles angles = MeasureCornerAngles(t, lengths);
  std::vector<Eigen::Vector2d> place(t.vertex.size(), Eigen::Vector2d::Zero());
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const double a = angles.value[h], far = lengths.value[t.edge[h + 1]];
    place[h + 1] = {lengths.value[t.edge[h + 2]], 0};
    place[h + 2] = {far * std::cos(a), far * std::sin(a)};
  }
  return place;
}

/// Where a corner of an overlay's face is in its face.
Eigen::Vector2d Place(const Triangulation& t, const std::vector<Eigen::Vector2d>& place,
                      bool vertex, Index at, double along_edge) {
  if (vertex) return place[at];
  const double along = t.edge_halfedge[t.edge[at]] == at ? along_edge : 1 - along_edge;
  return (1 - along) * place[Triangulation::Next(at)] + along * place[Triangulation::Prev(at)];
}

double Area(const std::vector<Eigen::Vector2d>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/// Every face of the overlay is the same polygon in its face of either triangulation, and they fill
/// both.
void ExpectSameShapes(const Triangulation& input, const EdgeLengths& lengths,
                      const Flipped& flipped) {
  const Triangulation& other = flipped.triangulation;
  const Overlay overlay = OverlayOf(input, flipped);
  const auto in_input = FacesInPlane(input, lengths);
  const auto in_other = FacesInPlane(other, flipped.lengths);
  std::vector<double> input_area(input.num_faces(), 0), other_area(other.num_faces(), 0);
  for (Index p = 0; p < overlay.num_faces(); ++p) {
    std::vector<Eigen::Vector2d> a, b;
    for (Index c = overlay.first_corner[p]; c < overlay.first_corner[p + 1]; ++c) {
      const Overlay::Corner& corner = overlay.corner[c];
      const bool vertex = corner.vertex < overlay.num_vertices;
      const Crossing crossing =
          vertex ? Crossing() : overlay.crossing[corner.vertex - overlay.num_vertices];
      ASSERT_EQ(corner.input / 3, overlay.input_face[p]);
      ASSERT_EQ(corner.other / 3, overlay.other_face[p]);
      if (vertex) {
        ASSERT_EQ(input.vertex[corner.input], corner.vertex);
        ASSERT_EQ(other.vertex[corner.other], corner.vertex);
      } else {
        ASSERT_EQ(input.edge[corner.input], input.edge[crossing.input]);
        ASSERT_EQ(other.edge[corner.other], other.edge[crossing.other]);
      }
      a.push_back(Place(input, in_input, vertex, corner.input, crossing.along_input));
      b.push_back(Place(other, in_other, vertex, corner.other, crossing.along_other));
    }
    ASSERT_TRUE(a.size() >= 3 && a.size() <= 6);
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_NEAR((a[i] - a[j]).norm(), (b[i] - b[j]).norm(), 1e-9);
      }
    }
    EXPECT_GT(Area(a), 0);
    input_area[overlay.input_face[p]] += Area(a);
    other_area[overlay.other_face[p]] += Area(b);
  }
  for (Index f = 0; f < input.num_faces(); ++f) {
    const double whole = Area({in_input[3 * f], in_input[3 * f + 1], in_input[3 * f + 2]});
    EXPECT_NEAR(input_area[f], whole, 1e-11);
    const double other_whole = Area({in_other[3 * f], in_other[3 * f + 1], in_other[3 * f + 2]});
    EXPECT_NEAR(other_area[f], other_whole, 1e-11);
  }
}

EdgeLengths Ones(const Triangulation& t) { return {Eigen::VectorXd::Ones(t.num_edges())}; }

TEST(Overlay, CountsTheCrossingsOfStraightEdgesInThePlane) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 60);
  const Triangulation& t = patch.triangulation;
  const Flipped flipped = FlipAtRandom(t, MeasureEdgeLengths(patch), 150, 3);
  ASSERT_GT(flipped.flips.size(), 20u);
  NormalCoordinates normal(t);
  for (const Index h : flipped.flips) normal.Flip(h);
  const auto at = [&](Index v) -> Eigen::Vector2d { return patch.position[v].head<2>(); };
  const Triangulation& other = flipped.triangulation;
  for (Index e = 0; e < other.num_edges(); ++e) {
    const Index h = other.edge_halfedge[e];
    const Index a = other.Tail(h), b = other.Tip(h);
    int crossings = 0;
    bool shared = false;
    for (Index i = 0; i < t.num_edges(); ++i) {
      const Index c = t.Tail(t.edge_halfedge[i]), d = t.Tip(t.edge_halfedge[i]);
      shared = shared || std::minmax(a, b) == std::minmax(c, d);
      if (a == c || a == d || b == c || b == d) continue;
      const bool cross =
          OrientationSign(at(a), at(b), at(c)) * OrientationSign(at(a), at(b), at(d)) < 0 &&
          OrientationSign(at(c), at(d), at(a)) * OrientationSign(at(c), at(d), at(b)) < 0;
      crossings += cross ? 1 : 0;
    }
    EXPECT_EQ(normal.Crossings(h), crossings) << e;
    EXPECT_EQ(normal.IsShared(h), shared) << e;
    if (shared) {
      EXPECT_EQ(t.Tail(normal.SharedHalfedge(h)), a);
    }
  }
}

TEST(Overlay, HasFacesOfTheSameShapeInBothTriangulations) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 100);
  const Surface terrain = GeneratedSurface("bumpy_terrain", 120);
  const Surface torus = GeneratedSurface("torus", 400);
  for (const Surface* surface : {&patch, &terrain, &torus}) {
    for (unsigned seed = 1; seed < 6; ++seed) {
      const EdgeLengths lengths = MeasureEdgeLengths(*surface);
      const Flipped flipped = FlipAtRandom(surface->triangulation, lengths, 400, seed);
      ASSERT_GT(flipped.flips.size(), 50u);
      ExpectSameShapes(surface->triangulation, lengths, flipped);
    }
  }
}

TEST(Overlay, TakesFacesGluedToThemselvesAndEdgesBetweenTheSameVertices) {
  const Surface fan = Fan(6, 0.5);
  const Triangulation folded = WithFoldedFace(fan.triangulation, 1);
  const Surface tetrahedron = RegularPolyhedron(4);
  const Triangulation closed = WithFoldedFace(tetrahedron.triangulation, 3);
  int self_glued = 0;
  for (const Triangulation* t : {&folded, &closed, &tetrahedron.triangulation}) {
    for (unsigned seed = 1; seed < 30; ++seed) {
      const Flipped flipped = FlipAtRandom(*t, Ones(*t), 40, seed);
      ExpectSameShapes(*t, Ones(*t), flipped);
      for (Index h = 0; h < t->num_halfedges(); ++h) {
        const Index g = flipped.triangulation.twin[h];
        self_glued += g != kNone && g / 3 == h / 3 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(self_glued, 50);
}

TEST(Overlay, OfAnInputWithItselfIsTheInput) {
  const Surface torus = GeneratedSurface("torus", 400);
  const Triangulation& t = torus.triangulation;
  const Overlay overlay = OverlayOf(t, {{}, t, MeasureEdgeLengths(torus)});
  EXPECT_TRUE(overlay.crossing.empty());
  ASSERT_EQ(overlay.num_faces(), t.num_faces());
  for (Index f = 0; f < t.num_faces(); ++f) {
    EXPECT_EQ(overlay.input_face[f], f);
    EXPECT_EQ(overlay.other_face[f], f);
  }
}

TEST(NormalCoordinates, FourFlipsOfAnEdgeAreNone) {
  const Surface torus = GeneratedSurface("torus", 400);
  const Triangulation& t = torus.triangulation;
  NormalCoordinates normal(t);
  for (const Index h : FlipAtRandom(t, MeasureEdgeLengths(torus), 300, 5).flips) normal.Flip(h);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (normal.complex().twin(h) / 3 == h / 3) continue;
    const NormalCoordinates before = normal;
    normal.Flip(h);
    EXPECT_NE(normal.complex().vertex(h), before.complex().vertex(h));
    for (int i = 0; i < 3; ++i) normal.Flip(h);
    for (Index g = 0; g < t.num_halfedges(); ++g) {
      ASSERT_EQ(normal.complex().twin(g), before.complex().twin(g));
      ASSERT_EQ(normal.Crossings(g), before.Crossings(g));
      ASSERT_EQ(normal.IsShared(g), before.IsShared(g));
      ASSERT_EQ(normal.Rank(g), before.Rank(g));
    }
  }
}

TEST(Overlay, FlipsTakenBackLeaveTheInput) {
  const Surface terrain = GeneratedSurface("bumpy_terrain", 120);
  const Triangulation& t = terrain.triangulation;
  Flipped flipped = FlipAtRandom(t, MeasureEdgeLengths(terrain), 300, 2);
  const std::vector<Index> there = flipped.flips;
  for (auto h = there.rbegin(); h != there.rend(); ++h) {
    flipped.flips.insert(flipped.flips.end(), 3, *h);
  }
  const auto overlay =
      MakeOverlay(t, flipped.flips, StraightLines(t, MeasureEdgeLengths(terrain)), t.num_faces());
  ASSERT_TRUE(overlay.ok());
  EXPECT_TRUE(overlay->crossing.empty());
  EXPECT_EQ(overlay->input_face, overlay->other_face);
}

TEST(Overlay, RefusesMoreFacesThanItMayHave) {
  const Surface fan = Fan(5, 0.0);
  const Flipped one = FlipAtRandom(fan.triangulation, Ones(fan.triangulation), 200, 1);
  ASSERT_FALSE(one.flips.empty());
  const auto refused =
      MakeOverlay(fan.triangulation, one.flips, StraightLines(one.triangulation, one.lengths), 5);
  EXPECT_EQ(refused.status().code(), StatusCode::kInvalidInput);
}

TEST(Overlay, SeparatesWhatRoundingHasJoined) {
  std::vector<double> along = {0, 0.5, 0.5, 0.4, 1};
  Separate(0.01, &along);
  const double expected[] = {0.01, 0.5, 0.51, 0.52, 0.99};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(along[i], expected[i], 1e-15);
  std::vector<double> crowded(9, 0.3);
  Separate(0.5, &crowded);
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(crowded[i], 0.1 * (i + 1), 1e-12);
}

}  // namespace
}  // namespace cirque
