#include "cirque/verify/topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TriangleMesh Fans(const PolygonSoup& soup) { return *FanTriangulate(soup); }

PolygonSoup OnePolygon(int corners) {
  std::vector<Eigen::Vector3d> position;
  for (int i = 0; i < corners; ++i) {
    position.emplace_back(std::cos(2 * kPi * i / corners), std::sin(2 * kPi * i / corners), 0);
  }
  PolygonSoup soup = MakeSoup(std::move(position), {});
  soup.corner.resize(corners);
  std::iota(soup.corner.begin(), soup.corner.end(), 0);
  soup.first_corner = {0, corners};
  return soup;
}

TEST(FanTriangulate, APolygonOfNCornersIsNMinusTwoTrianglesAtItsFirst) {
  const TriangleMesh mesh = Fans(OnePolygon(5));
  EXPECT_THAT(mesh.vertex, ElementsAre(0, 1, 2, 0, 2, 3, 0, 3, 4));
  EXPECT_EQ(mesh.soup_corner, mesh.vertex);
  EXPECT_THAT(mesh.face, ElementsAre(0, 0, 0));
  EXPECT_THAT(mesh.diagonal, ElementsAre(0, 0, 1, 1, 0, 1, 1, 0, 0));
}

TEST(FanTriangulate, FacesThatAreNoneAreNamed) {
  EXPECT_THAT(FanTriangulate(OnePolygon(2)).status().message(), HasSubstr("face 0 has 2 corners"));
  PolygonSoup soup = OnePolygon(4);
  soup.corner[2] = -1;
  EXPECT_THAT(FanTriangulate(soup).status().message(), HasSubstr("face 0 names vertex -1"));
}

// An edge has two triangles or is on the boundary, and being the other side is mutual.
TEST(PairHalfedges, TwinsAreMutualAndShareTheirEdge) {
  const TriangleMesh mesh = Fans(Sheet(5));
  const std::vector<Index> twin = *PairHalfedges(mesh);
  Index boundary = 0;
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    if (twin[h] == kNone) {
      ++boundary;
      continue;
    }
    EXPECT_EQ(twin[twin[h]], h);
    EXPECT_EQ(mesh.Tail(twin[h]), mesh.Tip(h));
    EXPECT_EQ(mesh.Tip(twin[h]), mesh.Tail(h));
  }
  EXPECT_EQ(boundary, 20);
}

// Two quadrilaterals that share two edges, and a diagonal in common if they are cut so.
TEST(PairHalfedges, DiagonalsStayInsideTheirFaces) {
  PolygonSoup doublet = MakeSoup(std::vector<Eigen::Vector3d>(5, {0, 0, 0}), {});
  doublet.corner = {0, 1, 2, 4, 0, 4, 2, 3};
  doublet.first_corner = {0, 4, 8};
  const StatusOr<Surface> surface = BuildSurface(Fans(doublet));
  ASSERT_TRUE(surface.ok()) << surface.status().message();
  const std::vector<Index>& face = surface->mesh.face;
  for (Index h = 0; h < 12; ++h) {
    if (!surface->mesh.diagonal[h]) continue;
    EXPECT_EQ(face[h / 3], face[surface->twin[h] / 3]);
  }
  EXPECT_EQ(std::count(surface->twin.begin(), surface->twin.end(), kNone), 4);
}

TEST(OrientConsistently, TurnsTheMinorityOfEveryComponentAndNothingElse) {
  const PolygonSoup good = Sheet(3);
  PolygonSoup soup = good;
  for (const Index f : {4, 11}) std::swap(soup.corner[3 * f], soup.corner[3 * f + 1]);
  TriangleMesh mesh = Fans(soup);
  EXPECT_THAT(*OrientConsistently(*PairHalfedges(mesh), &mesh), ElementsAre(4, 11));
  const std::vector<Index> twin = *PairHalfedges(mesh);
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    if (twin[h] == kNone) continue;
    EXPECT_EQ(mesh.Tail(h), mesh.Tip(twin[h]));
  }
  // Where most run the other way round the few are the ones to be turned.
  soup = good;
  for (Index f = 0; f < soup.num_polygons(); ++f) {
    if (f != 4 && f != 11) std::swap(soup.corner[3 * f], soup.corner[3 * f + 1]);
  }
  mesh = Fans(soup);
  EXPECT_THAT(*OrientConsistently(*PairHalfedges(mesh), &mesh), ElementsAre(4, 11));
}

TEST(OrientConsistently, AMoebiusStripCannotBeOriented) {
  std::vector<Triangle> strip;
  for (Index i = 0; i < 5; ++i) strip.push_back({i, (i + 1) % 5, (i + 2) % 5});
  const StatusOr<Surface> surface =
      BuildSurface(Fans(MakeSoup(std::vector<Eigen::Vector3d>(5, {0, 0, 0}), strip)));
  EXPECT_THAT(surface.status().message(), HasSubstr("not orientable"));
}

TEST(BuildSurface, RefusesEdgesAndVerticesThatJoinSheets) {
  const std::vector<Eigen::Vector3d> points(6, {0, 0, 0});
  const auto message = [&](const std::vector<Triangle>& triangles) {
    const StatusOr<TriangleMesh> mesh = FanTriangulate(MakeSoup(points, triangles));
    return mesh.ok() ? BuildSurface(*mesh).status().message() : mesh.status().message();
  };
  EXPECT_THAT(message({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), HasSubstr("edge (0, 1) has 3 faces"));
  EXPECT_THAT(message({{0, 1, 2}, {0, 3, 4}}), HasSubstr("vertex 0 joins several fans"));
  EXPECT_THAT(message({{2, 2, 1}}), HasSubstr("face 0 has vertex 2 twice"));
}

// Whoever numbers the triangles and vertices otherwise describes the same surface.
TEST(BuildSurface, BoundaryAndInteriorDoNotDependOnNumbers) {
  const PolygonSoup soup = Sheet(4);
  std::vector<Index> number(soup.position.size());
  std::iota(number.begin(), number.end(), 0);
  std::mt19937 random(3);
  const auto boundary_edges = [](const PolygonSoup& mesh) {
    const Surface surface = *BuildSurface(Fans(mesh));
    return std::count(surface.twin.begin(), surface.twin.end(), kNone);
  };
  for (int trial = 0; trial < 5; ++trial) {
    std::shuffle(number.begin(), number.end(), random);
    PolygonSoup renumbered = soup;
    for (Index& v : renumbered.corner) v = number[v];
    EXPECT_EQ(boundary_edges(renumbered), boundary_edges(soup));
    EXPECT_THAT(BuildSurface(Fans(renumbered))->turned, IsEmpty());
  }
}

}  // namespace
}  // namespace cirque::verify
