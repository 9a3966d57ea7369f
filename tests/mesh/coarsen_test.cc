#include "cirque/mesh/coarsen.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/core/triangulation.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(Coarsen, KeepsTopologyAndComesNearTheNumberOfFaces) {
  for (const char* generator : {"torus", "hemisphere", "sphere", "bumpy_terrain"}) {
    SCOPED_TRACE(generator);
    const Surface surface = GeneratedSurface(generator, 8000);
    const Triangulation& t = surface.triangulation;
    const CoarseSurface coarse = Coarsen(surface, 1000);
    EXPECT_NEAR(coarse.soup.num_polygons(), 1000, 20);
    const Surface left = SurfaceOf(coarse.soup);
    EXPECT_EQ(EulerCharacteristic(left.triangulation), EulerCharacteristic(t));
    EXPECT_EQ(BoundaryLoops(left.triangulation).size(), BoundaryLoops(t).size());
    // What is left lies where it lay, and everything else is in the log.
    EXPECT_EQ(coarse.vertex.size() + coarse.collapses.size(), surface.position.size());
    for (std::size_t v = 0; v < coarse.vertex.size(); ++v) {
      EXPECT_EQ(coarse.soup.position[v], surface.position[coarse.vertex[v]]);
    }
  }
}

TEST(Coarsen, LeavesAPlaneRectangleOfThickTriangles) {
  const CoarseSurface coarse = Coarsen(FlatStrip(40, 40), 400);
  double area = 0;
  for (Index f = 0; f < coarse.soup.num_polygons(); ++f) {
    const auto at = [&](int k) -> const Eigen::Vector3d& {
      return coarse.soup.position[coarse.soup.corner[3 * f + k]];
    };
    const Eigen::Vector3d a = at(1) - at(0), b = at(2) - at(0);
    const double doubled = a.x() * b.y() - a.y() * b.x();
    EXPECT_GT(doubled, 0.15 * std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()}));
    area += doubled / 2;
  }
  // Triangles turned over nowhere; along the boundary corners may have been cut off.
  EXPECT_LE(area, 1600 + 1e-9);
  EXPECT_GT(area, 1500);
}

// A roof of four planes: vertices go within planes and along folds, so that it stays what it is.
TEST(Coarsen, TakesVerticesInFlatSurroundingsFirst) {
  const auto fold = [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), std::abs(p.x() - 12) + std::abs(p.y() - 12));
  };
  const Surface roof = Moved(FlatStrip(24, 24), fold);
  const CoarseSurface coarse = Coarsen(roof, 300);
  EXPECT_NEAR(coarse.soup.num_polygons(), 300, 20);
  double doubled_area = 0;
  for (Index f = 0; f < coarse.soup.num_polygons(); ++f) {
    const auto at = [&](int k) { return coarse.soup.position[coarse.soup.corner[3 * f + k]]; };
    const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0));
    EXPECT_NEAR(std::abs(normal.x()), normal.z(), 1e-9);
    EXPECT_NEAR(std::abs(normal.y()), normal.z(), 1e-9);
    doubled_area += normal.norm();
  }
  EXPECT_NEAR(doubled_area, 2 * 24 * 24 * std::sqrt(3), 1e-9);
}

// The faces around each vertex taken away, in the order in which they were then.
TEST(Coarsen, LogsStarsThatHangTogether) {
  const Surface surface = GeneratedSurface("torus", 2000);
  CoarseSurface coarse = Coarsen(surface, 500);
  const CollapseLog& log = coarse.collapses;
  auto corner = log.corner;
  for (std::size_t i = log.size(); i-- > 0;) {
    const std::size_t first = log.first_face[i], end = log.first_face[i + 1];
    for (std::size_t k = first; k < end; ++k) {
      auto& face = corner[log.face[k]];
      const bool ends = k == first || k + 1 == end;
      const auto has = [&](Index v) {
        return std::find(face.begin(), face.end(), v) != face.end();
      };
      ASSERT_TRUE(has(log.kept[i]));
      ASSERT_EQ(has(log.removed[i]), ends);
      if (!ends) *std::find(face.begin(), face.end(), log.kept[i]) = log.removed[i];
    }
    // Counter-clockwise: each face ends where the next begins.
    const auto around = [&](std::size_t k, Index step) {
      const auto& face = corner[log.face[k]];
      const auto at = std::find(face.begin(), face.end(), log.removed[i]) - face.begin();
      return face[(at + step) % 3];
    };
    for (std::size_t k = first; k < end; ++k) {
      ASSERT_EQ(around(k, 2), around(k + 1 < end ? k + 1 : first, 1));
    }
  }
  for (Index c = 0; c < surface.triangulation.num_halfedges(); ++c) {
    EXPECT_EQ(corner[c / 3][c % 3], surface.triangulation.vertex[c]);
  }
}

TEST(Coarsen, OfFewerFacesTheSurfaceIsAsItWas) {
  const Surface surface = FlatStrip(3, 3);
  const CoarseSurface coarse = Coarsen(surface, 18);
  EXPECT_EQ(coarse.collapses.size(), 0u);
  EXPECT_EQ(coarse.soup.corner, surface.triangulation.vertex);
  EXPECT_EQ(coarse.face.size(), 18u);
}

}  // namespace
}  // namespace cirque
