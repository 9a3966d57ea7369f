// Maps brought onto a lattice, as their coordinates alone tell it.
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/lattice/lattice_map.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using Complex = std::complex<double>;

ParameterizeOptions OnLattice(HolonomyRule holonomy, int cells) {
  ParameterizeOptions options;
  options.holonomy = holonomy;
  options.integer_cells = cells;
  return options;
}

/// The largest distance, over all edges, of the motion from one side to the other from one that takes
/// the lattice to itself; without a look at the cut.
double LargestJump(const Triangulation& t, const CornerUv& uv, LatticeKind kind) {
  const auto at = [&](Index c) { return Complex(uv.value[c].x(), uv.value[c].y()); };
  double largest = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index twin = t.twin[h];
    const Complex a = at(Triangulation::Next(h)), b = at(Triangulation::Prev(h));
    const Complex a2 = at(Triangulation::Prev(twin)), b2 = at(Triangulation::Next(twin));
    const Complex turn = (b2 - a2) / (b - a), shift = a2 - turn * a;
    const Eigen::Vector2d place(shift.real(), shift.imag());
    largest = std::max({largest, std::abs(std::pow(turn, OrderOf(kind)) - 1.),
                        (NearestInLattice(kind, place) - place).norm()});
  }
  return largest;
}

TEST(WholeTranslations, TakeTheLatticeToItselfAcrossEveryEdge) {
  for (const auto& [name, triangles] : {std::pair("double_torus", 2000), std::pair("torus", 800)}) {
    const Surface surface = GeneratedSurface(name, triangles);
    for (const auto& [holonomy, kind] :
         {std::pair(HolonomyRule::kHalves, LatticeKind::kSquares),
          std::pair(HolonomyRule::kThirds, LatticeKind::kTriangles)}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(OrderOf(kind)));
      Parameterization map;
      const Status status = Parameterize(surface, {OnLattice(holonomy, 4000)}, {}, &map);
      ASSERT_TRUE(status.ok()) << status.message();
      EXPECT_EQ(map.certificate.outcome, "ok") << map.certificate.message;
      ASSERT_TRUE(map.certificate.integers);
      EXPECT_LT(LargestJump(surface.triangulation, map.uv, kind), 1e-8);
      EXPECT_LT(map.certificate.integers->integer_gap.value_or(1), 1e-8);
      EXPECT_GT(map.certificate.integers->integer_shift.value_or(0), 0);
      EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
      // About so many cells: the area in the plane.
      double area = 0;
      for (std::size_t c = 0; c < map.uv.value.size(); c += 3)
        area += Cross(map.uv.value[c], map.uv.value[c + 1], map.uv.value[c + 2]) / 2;
      const double cell = kind == LatticeKind::kSquares ? 1 : std::sqrt(3.) / 4;
      EXPECT_NEAR(area / cell, 4000, 0.1 * 4000);
    }
  }
}

TEST(WholeTranslations, ThatWouldFlipATriangleAreNotMade) {
  const Surface surface = GeneratedSurface("double_torus", 2000);
  Parameterization seamless, map;
  ASSERT_TRUE(Parameterize(surface, {OnLattice(HolonomyRule::kHalves, 0)}, {}, &seamless).ok());
  ASSERT_TRUE(Parameterize(surface, {OnLattice(HolonomyRule::kHalves, 2)}, {}, &map).ok());
  EXPECT_EQ(map.certificate.outcome, "inaccurate");
  EXPECT_THAT(map.certificate.message, HasSubstr("not on a lattice"));
  EXPECT_THAT(map.certificate.message, HasSubstr("smaller cells"));
  EXPECT_EQ(map.uv.value, seamless.uv.value) << "the seamless map is what is left";
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
}

TEST(WholeTranslations, NeedRotationsByMultiplesAndAClosedSurface) {
  ParameterizeOptions options = OnLattice(HolonomyRule::kFree, 100);
  EXPECT_THAT(CheckOptions(options).message(), HasSubstr("holonomy = pi/2"));
  options = OnLattice(HolonomyRule::kHalves, 100);
  options.injective = true;
  EXPECT_THAT(CheckOptions(options).message(), HasSubstr("leave out injective"));
  Parameterization map;
  const Surface disk = GeneratedSurface("bumpy_terrain", 200);
  const Status status = Parameterize(disk, {OnLattice(HolonomyRule::kHalves, 100)}, {}, &map);
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr("boundary"));
}

}  // namespace
}  // namespace cirque
