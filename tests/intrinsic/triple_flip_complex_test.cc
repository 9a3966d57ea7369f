// Quadrilaterals in the plane whose shape lies in digits that doubles do not have.
#include "cirque/intrinsic/triple_flip_complex.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TripleDouble Hypotenuse(double a, double b) {
  return Sqrt(TripleDouble(a) * a + TripleDouble(b) * b);
}

/// A square's two triangles, with other lengths: the diagonal's and those of the sides at the apex on
/// its left and on its right.
struct Quadrilateral {
  Quadrilateral(const TripleDouble& diagonal, const TripleDouble& left, const TripleDouble& right)
      : t(FlatStrip(1, 1).triangulation), length(t.num_edges()) {
    Index e = 0;
    while (t.IsBoundaryEdge(e)) ++e;
    h = t.edge_halfedge[e];
    length[e] = diagonal;
    for (const Index side : {Triangulation::Next(h), Triangulation::Prev(h)}) {
      length[t.edge[side]] = left;
    }
    for (const Index side : {Triangulation::Next(t.twin[h]), Triangulation::Prev(t.twin[h])}) {
      length[t.edge[side]] = right;
    }
  }

  Triangulation t;
  std::vector<TripleDouble> length;
  Index h;
};

/// Apexes at 0.3 and 0.9 on either side of a diagonal of 2 w.
Quadrilateral Kite(double w) { return {2 * w, Hypotenuse(0.3, w), Hypotenuse(0.9, w)}; }

TEST(TripleFlipComplex, TurnsAKitesShortDiagonalHoweverShort) {
  for (const double w : {0.5, 1e-3, 4e-9, 1e-12}) {
    const Quadrilateral kite = Kite(w);
    TripleFlipComplex metric(kite.t, kite.length);
    ASSERT_TRUE(metric.Turn(kite.h)) << w;
    EXPECT_NEAR(metric.complex().length(kite.h), 0.3 + 0.9, 4e-16);
    for (const Index h : {kite.h, metric.twin(kite.h)}) {
      EXPECT_NEAR(metric.Angle(h), std::atan(0.3 / w) + std::atan(0.9 / w), 2e-15) << w;
      const double ends =
          metric.Angle(Triangulation::Next(h)) * metric.Angle(Triangulation::Prev(h));
      EXPECT_NEAR(ends / (std::atan(w / 0.3) * std::atan(w / 0.9)), 1, 1e-6) << w;
    }
  }
}

TEST(TripleFlipComplex, TurnsWhatDoublesCannot) {
  int refused = 0;
  for (int i = 1; i <= 50; ++i) {
    const Quadrilateral kite = Kite(1e-10 * i);
    EdgeLengths rounded{Eigen::VectorXd(kite.t.num_edges())};
    for (Index e = 0; e < kite.t.num_edges(); ++e) rounded.value[e] = kite.length[e].Value();
    refused += FlipComplex(kite.t, rounded).OtherDiagonal(kite.h).has_value() ? 0 : 1;
    EXPECT_TRUE(TripleFlipComplex(kite.t, kite.length).Turn(kite.h)) << i;
  }
  EXPECT_GT(refused, 0);
}

TEST(TripleFlipComplex, TwoTurnsAreNone) {
  const Quadrilateral kite = Kite(0.2);
  TripleFlipComplex metric(kite.t, kite.length);
  ASSERT_TRUE(metric.Turn(kite.h));
  ASSERT_TRUE(metric.Turn(kite.h));
  // Each side of the diagonal has the other's face then.
  EXPECT_NEAR(metric.complex().length(kite.h), 0.4, 1e-16);
  for (const Index h : {kite.h, kite.t.twin[kite.h]}) {
    const double of_twin = kite.length[kite.t.edge[Triangulation::Next(kite.t.twin[h])]].Value();
    EXPECT_EQ(metric.complex().length(Triangulation::Next(h)), of_twin);
    EXPECT_EQ(metric.complex().length(Triangulation::Prev(h)), of_twin);
  }
}

TEST(TripleFlipComplex, LeavesWhatIsNotConvex) {
  // Both apexes so near the diagonal's line that its ends stay where they are, one beyond them.
  const Surface dented = Moved(FlatStrip(1, 1), [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return x.x() > 0.5 && x.y() > 0.5 ? Eigen::Vector3d(0.2, 0.2, 0) : x;
  });
  const Triangulation& t = dented.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(dented);
  Index e = 0;
  while (t.IsBoundaryEdge(e)) ++e;
  const Index h = t.edge_halfedge[e];
  const std::vector<TripleDouble> extended(lengths.value.begin(), lengths.value.end());
  TripleFlipComplex metric(t, extended);
  const bool convex = FlipComplex(t, lengths).OtherDiagonal(h).has_value();
  EXPECT_EQ(metric.Turn(h), convex);
  EXPECT_FALSE(convex);
  EXPECT_EQ(metric.complex().length(h), lengths.value[e]);
}

}  // namespace
}  // namespace cirque
