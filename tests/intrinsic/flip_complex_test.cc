// Flips on lengths alone against the same quadrilaterals unfolded in fifty digits.
#include "cirque/intrinsic/flip_complex.h"

#include <cmath>
#include <random>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>,
                                           boost::multiprecision::et_off>;

/// Sides of two triangles a b c (on the left of the edge from a to b) and b a d (on its right).
struct QuadSides {
  double ab, bc, ca, ad, db;
};

/// The halfedge from a to b is 0; face 0 has its corners at c, a, b, face 1 at d, b, a.
FlipComplex Quad(const QuadSides& q) {
  const Triangulation t = NumberEdges(4, {2, 0, 1, 3, 1, 0}, {3, kNone, kNone, 0, kNone, kNone});
  const double side[] = {q.ab, q.bc, q.ca, q.ab, q.ad, q.db};
  EdgeLengths lengths{Eigen::VectorXd(5)};
  for (Index h = 0; h < 6; ++h) lengths.value[t.edge[h]] = side[h];
  return FlipComplex(t, lengths);
}

/// Where the apex lies over the edge from (0, 0) to (base, 0), at these distances from its ends.
struct Apex {
  Real x, y;
};

Apex Unfold(double base, double from_tail, double from_tip) {
  const Real b(base), p(from_tail), q(from_tip);
  const Real x = (b * b + p * p - q * q) / (2 * b);
  return {x, sqrt(p * p - x * x)};
}

/// The distance of c and d, unfolded to both sides of the edge.
Real Diagonal(const QuadSides& q) {
  const Apex c = Unfold(q.ab, q.ca, q.bc), d = Unfold(q.ab, q.ad, q.db);
  const Real dx = c.x - d.x, dy = c.y + d.y;
  return sqrt(dx * dx + dy * dy);
}

/// Whether the diagonal passes between the edge's ends.
bool IsConvex(const QuadSides& q) {
  const Apex c = Unfold(q.ab, q.ca, q.bc), d = Unfold(q.ab, q.ad, q.db);
  const Real crossing = (c.x * d.y + d.x * c.y) / (c.y + d.y);
  return crossing > 0 && crossing < q.ab;
}

double RelativeError(double value, const Real& exact) {
  return static_cast<double>(abs(Real(value) / exact - 1));
}

QuadSides FromPoints(const Eigen::Vector2d& c, const Eigen::Vector2d& d, double base) {
  const Eigen::Vector2d a(0, 0), b(base, 0);
  return {base, (c - b).norm(), c.norm(), d.norm(), (d - b).norm()};
}

TEST(FlipComplex, OtherDiagonalIsThatOfTheUnfoldedQuad) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-0.5, 1.5), height(0.05, 1);
  int convex = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const double scale = std::pow(10, trial % 7 - 3);
    const QuadSides q = FromPoints(scale * Eigen::Vector2d(x(random), height(random)),
                                   scale * Eigen::Vector2d(x(random), -height(random)), scale);
    const std::optional<double> length = Quad(q).OtherDiagonal(0);
    ASSERT_EQ(length.has_value(), IsConvex(q)) << trial;
    if (!length) continue;
    ++convex;
    EXPECT_LT(RelativeError(*length, Diagonal(q)), 1e-13) << trial;
  }
  EXPECT_GT(convex, 200);
  EXPECT_LT(convex, 450);
}

TEST(FlipComplex, OtherDiagonalIsAccurateForNeedles) {
  // A long edge, apexes just above and below it: the diagonal is far shorter than all the sides.
  for (const double height : {1e-2, 1e-4, 1e-6}) {
    const QuadSides q = FromPoints({0.5, height}, {0.5, -height}, 1);
    const std::optional<double> length = Quad(q).OtherDiagonal(0);
    ASSERT_TRUE(length);
    // Rounded lengths know a height h to about 1e-16 / h^2 of it, the formula loses no more.
    EXPECT_LT(RelativeError(*length, Diagonal(q)), 1e-13 + 1e-16 / (height * height)) << height;
    EXPECT_NEAR(*length, 2 * height, 1e-3 * height + 1e-16 / height);
  }
  // Two needles with their tips together.
  const QuadSides thin = FromPoints({1e6, 1}, {1e6, -2}, 1);
  EXPECT_FALSE(Quad(thin).OtherDiagonal(0));
  const QuadSides long_one = FromPoints({0.4, 1e6}, {0.6, -1e6}, 1);
  const std::optional<double> length = Quad(long_one).OtherDiagonal(0);
  ASSERT_TRUE(length);
  EXPECT_LT(RelativeError(*length, Diagonal(long_one)), 1e-14);
}

TEST(FlipComplex, NoDiagonalOutsideOrAlongASide) {
  EXPECT_FALSE(Quad(FromPoints({2, 0.5}, {0.5, -1}, 1)).OtherDiagonal(0));
  EXPECT_FALSE(Quad(FromPoints({-1, 0.1}, {0.5, -1}, 1)).OtherDiagonal(0));
  // Two right angles at b, in whole numbers: one new face had no area.
  EXPECT_FALSE(Quad({3, 4, 5, 5, 4}).OtherDiagonal(0));
}

TEST(FlipComplex, DelaunayRatioSaysWhetherAnglesExceedPi) {
  // A rhombus with diagonals 2 and 2 h: the angles opposite the first are both 2 atan(1 / h).
  for (const double h : {0.1, 0.5, 0.99, 1.01, 3.0}) {
    const double side = std::hypot(1, h);
    const FlipComplex rhombus = Quad({2, side, side, side, side});
    EXPECT_NEAR(rhombus.SquaredHalfTangent(0), 1 / (h * h), 1e-12 / (h * h));
    EXPECT_NEAR(rhombus.DelaunayRatio(0), std::pow(h, -4), 1e-12 * std::pow(h, -4));
    EXPECT_EQ(rhombus.DelaunayRatio(0) > 1, h < 1);
    // The other diagonal's is the inverse.
    EXPECT_NEAR(*rhombus.OtherDiagonal(0), 2 * h, 1e-13);
    EXPECT_NEAR(rhombus.RatioAfterFlip(0, 2 * h), std::pow(h, 4), 1e-11 * std::pow(h, 4));
  }
  const double diagonal = std::sqrt(2.0);
  EXPECT_NEAR(Quad({diagonal, 1, 1, 1, 1}).DelaunayRatio(0), 1, 1e-15);
}

struct Arrays {
  std::vector<Index> vertex, twin, label;

  explicit Arrays(const FlipComplex& complex) {
    for (Index h = 0; h < complex.num_halfedges(); ++h) {
      vertex.push_back(complex.vertex(h));
      twin.push_back(complex.twin(h));
      label.push_back(complex.label(h));
    }
  }
  bool operator==(const Arrays&) const = default;
};

TEST(FlipComplex, FlippingTurnsTheEdgeAndUnflippingBringsTheArraysBack) {
  FlipComplex complex = Quad({1, 1, 1, 1, 1});
  const Arrays before(complex);
  complex.Flip(0, std::sqrt(3.0), 77);
  // From d to c, with a on its left and b on its right.
  EXPECT_EQ(complex.vertex(Triangulation::Next(0)), 3);
  EXPECT_EQ(complex.vertex(Triangulation::Prev(0)), 2);
  EXPECT_EQ(complex.vertex(0), 0);
  EXPECT_EQ(complex.vertex(3), 1);
  EXPECT_EQ(complex.label(0), 77);
  EXPECT_EQ(complex.twin(0), 3);
  EXPECT_NE(Arrays(complex), before);
  complex.Unflip(0, 1, before.label[0]);
  EXPECT_EQ(Arrays(complex), before);
}

TEST(FlipComplex, AThousandFlipsUndoneInReverseOrderAreNone) {
  const Surface blob = GeneratedSurface("blob", 500);
  FlipComplex complex(blob.triangulation, MeasureEdgeLengths(blob));
  const Arrays before(complex);
  std::mt19937 random(5);
  struct Done {
    Index halfedge, label;
    double length;
  };
  std::vector<Done> done;
  const Triangulation& t = blob.triangulation;
  std::vector<double> length_of(t.num_edges());
  const EdgeLengths lengths = MeasureEdgeLengths(blob);
  for (Index e = 0; e < t.num_edges(); ++e) length_of[e] = lengths.value[e];
  while (done.size() < 1000) {
    const auto h = static_cast<Index>(random() % complex.num_halfedges());
    if (Triangulation::Face(h) == Triangulation::Face(complex.twin(h))) continue;
    const std::optional<double> length = complex.OtherDiagonal(h);
    if (!length || complex.RatioAfterFlip(h, *length) > 1e4) continue;
    done.push_back({h, complex.label(h), length_of[complex.label(h)]});
    const auto [of_h, of_twin] = complex.TangentsAfterFlip(h, *length);
    complex.Flip(h, *length, static_cast<Index>(length_of.size()));
    EXPECT_EQ(complex.SquaredHalfTangent(h), of_h) << "to the last bit";
    EXPECT_EQ(complex.SquaredHalfTangent(complex.twin(h)), of_twin);
    length_of.push_back(*length);
  }
  EXPECT_NE(Arrays(complex), before);
  for (auto flip = done.rbegin(); flip != done.rend(); ++flip) {
    complex.Unflip(flip->halfedge, flip->length, flip->label);
  }
  EXPECT_EQ(Arrays(complex), before);
  const Triangulation again = complex.MakeTriangulation(t.num_vertices);
  EXPECT_EQ(again.vertex, t.vertex);
  EXPECT_EQ(again.twin, t.twin);
  EXPECT_EQ(complex.MakeLengths(again).value, lengths.value);
}

}  // namespace
}  // namespace cirque
