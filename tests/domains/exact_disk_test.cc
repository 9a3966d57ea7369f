// Exact maps to the disk and the half-plane: judged by the independent judge, and held against what
// they claim, that they are linear on the triangles that were solved on.
#include "cirque/domains/exact_disk.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/mesh/split_chords.h"

#include "tests/common/exact_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

MapRequest ExactRequest(const std::string& domain) {
  MapRequest request;
  request.domain = domain;
  request.options.exact = true;
  return request;
}

/// Long triangles, so that there is much to be flipped.
Surface Stretched(const std::string& generator, Index triangles) {
  return Moved(GeneratedSurface(generator, triangles),
               [](const Eigen::Vector3d& x) { return Eigen::Vector3d(x.x(), x.y(), 3 * x.z()); });
}

/// Eight squares in a row over another, bent: every ear and every corner has a chord.
Surface BentStrip(int rows) {
  return Moved(FlatStrip(8, rows), [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x.x(), 2.5 * x.y() + 0.9 * x.x(), std::sin(1.1 * x.x()));
  });
}

/// The first fundamental form of a piece in coordinates of its image.
Eigen::Matrix2d FormOf(const Surface& surface, const ExactMap& map, Index piece) {
  Eigen::Vector3d at[3];
  Eigen::Vector2d image[3];
  for (Index k = 0; k < 3; ++k) {
    const Index f = map.face_of_input[piece], c = 3 * piece + k;
    const Eigen::Vector3d weight = InFace(surface.triangulation, map.point[map.corner[c]], f);
    at[k].setZero();
    for (Index j = 0; j < 3; ++j) {
      at[k] += weight[j] * surface.position[surface.triangulation.vertex[3 * f + j]];
    }
    image[k] = map.uv[map.corner_uv[c]];
  }
  Eigen::Matrix<double, 3, 2> edges;
  edges << at[1] - at[0], at[2] - at[0];
  Eigen::Matrix2d image_edges;
  image_edges << image[1] - image[0], image[2] - image[0];
  const Eigen::Matrix<double, 3, 2> jacobian = edges * image_edges.inverse();
  return jacobian.transpose() * jacobian;
}

/// Pieces of one solved face are parts of one flat triangle with one linear map: they have the same
/// form, although they lie in different faces of the input. Thin ones have fewer digits.
void ExpectLinearOnSolvedFaces(const Surface& surface, const ExactMap& map) {
  std::map<Index, Eigen::Matrix2d> of_solved;
  int compared = 0;
  for (Index p = 0; p < map.num_triangles(); ++p) {
    const auto uv = [&](Index k) { return map.uv[map.corner_uv[3 * p + k]]; };
    const Eigen::Vector2d a = uv(1) - uv(0), b = uv(2) - uv(0);
    const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
    if (a.x() * b.y() - a.y() * b.x() < 1e-4 * longest * longest) continue;
    const Eigen::Matrix2d form = FormOf(surface, map, p);
    const auto [known, is_new] = of_solved.emplace(map.face_of_solved[p], form);
    if (is_new) continue;
    ++compared;
    EXPECT_LT((form - known->second).norm(), 1e-6 * form.norm());
  }
  EXPECT_GT(compared, 5);
}

std::vector<std::complex<double>> Places(const Surface& surface, const ExactMap& map) {
  std::vector<std::complex<double>> place(surface.triangulation.num_vertices);
  for (std::size_t c = 0; c < map.corner.size(); ++c) {
    const Eigen::Vector2d& uv = map.uv[map.corner_uv[c]];
    if (map.corner[c] < surface.triangulation.num_vertices) {
      place[map.corner[c]] = {uv.x(), uv.y()};
    }
  }
  return place;
}

std::vector<Index> BoundaryOf(const Triangulation& t) {
  std::vector<Index> vertices;
  const std::vector<Index> loop = BoundaryLoops(t).front();
  for (const Index h : loop) vertices.push_back(t.Tail(h));
  return vertices;
}

TEST(ExactDisk, IsLinearOnTheSolvedFacesAndAccepted) {
  for (const char* name : {"bumpy_terrain", "hemisphere"}) {
    const Surface surface = Stretched(name, 500);
    for (const char* refine : {"none", "auto"}) {
      MapRequest request = ExactRequest("disk");
      request.options.refine_map = refine;
      const auto map = MapSurface(surface, request);
      ASSERT_TRUE(map.ok()) << map.status().message();
      ASSERT_TRUE(map->exact_map);
      EXPECT_GT(map->certificate.exact_map->exact_crossings, 20) << name;
      EXPECT_GT(map->certificate.exact_map->exact_faces_ratio, 1);
      ExpectExactMapIsAccepted(surface, *map);
      ExpectLinearOnSolvedFaces(surface, *map->exact_map);
      const auto place = Places(surface, *map->exact_map);
      const std::vector<Index> boundary = BoundaryOf(surface.triangulation);
      for (const Index v : boundary) EXPECT_NEAR(std::abs(place[v]), 1, 1e-15);
      EXPECT_EQ(place[map->certificate.disk->centre_vertex], 0.0);
      EXPECT_EQ(place[map->certificate.disk->angle_zero_vertex], 1.0);
    }
  }
}

TEST(ExactDisk, HasCentresOfMassWhereTheyAreAskedFor) {
  const Surface surface = Stretched("bumpy_terrain", 400);
  for (const char* normalization : {"boundary", "area"}) {
    MapRequest request = ExactRequest("disk");
    request.shape.normalization = normalization;
    const auto map = MapSurface(surface, request);
    ASSERT_TRUE(map.ok()) << map.status().message();
    ExpectExactMapIsAccepted(surface, *map);
  }
}

TEST(ExactDisk, OfWhatNeedsNoFlipIsTheMapAtTheVertices) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 300);
  MapRequest request = ExactRequest("disk");
  request.options.refine_map = "none";
  const auto map = MapSurface(patch, request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ExpectExactMapIsAccepted(patch, *map);
  const auto place = Places(patch, *map->exact_map);
  for (Index h = 0; h < patch.triangulation.num_halfedges(); ++h) {
    const std::complex<double> z = place[patch.triangulation.vertex[h]];
    EXPECT_LT((Eigen::Vector2d(z.real(), z.imag()) - map->uv.value[h]).norm(), 1e-12);
  }
}

TEST(ExactDisk, OfFacesBeyondChordsLiesInTheInputsFaces) {
  for (const int rows : {1, 3}) {
    const Surface strip = BentStrip(rows);
    MapRequest request = ExactRequest("disk");
    const auto map = MapSurface(strip, request);
    ASSERT_TRUE(map.ok()) << map.status().message();
    ASSERT_TRUE(map->certificate.disk->split_chords);
    EXPECT_GT(*map->certificate.disk->split_chords, 0);
    ExpectExactMapIsAccepted(strip, *map);
    for (const Index f : map->exact_map->face_of_input) {
      EXPECT_LT(f, strip.triangulation.num_faces());
    }
    EXPECT_GE(map->certificate.exact_map->exact_faces_worst,
              map->certificate.exact_map->exact_faces_ratio);
    ExpectLinearOnSolvedFaces(strip, *map->exact_map);
  }
}

TEST(ExactDisk, OfOneTriangleIsThatTriangle) {
  const Surface triangle = *SurfaceFromTriangles({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  for (const char* domain : {"disk", "half_plane"}) {
    const auto map = MapSurface(triangle, ExactRequest(domain));
    ASSERT_TRUE(map.ok()) << domain << ": " << map.status().message();
    EXPECT_EQ(map->exact_map->num_triangles(), 1);
    ExpectExactMapIsAccepted(triangle, *map);
  }
}

TEST(ExactHalfPlane, HasItsBoundaryOnTheRealAxis) {
  const Surface surface = Stretched("hemisphere", 500);
  for (const char* refine : {"none", "auto"}) {
    MapRequest request = ExactRequest("half_plane");
    request.options.refine_map = refine;
    const auto map = MapSurface(surface, request);
    ASSERT_TRUE(map.ok()) << map.status().message();
    ASSERT_TRUE(map->exact_map);
    EXPECT_GT(map->certificate.exact_map->exact_crossings, 20);
    ExpectExactMapIsAccepted(surface, *map);
    ExpectLinearOnSolvedFaces(surface, *map->exact_map);
    const auto place = Places(surface, *map->exact_map);
    const std::vector<Index> boundary = BoundaryOf(surface.triangulation);
    for (const Index v : boundary) {
      const bool is_pole = v == map->certificate.half_plane->pole_vertex;
      EXPECT_EQ(place[v].imag() > 0, is_pole);
      EXPECT_GE(place[v].imag(), 0);
    }
  }
}

TEST(ExactDisk, FlippedTrianglesAreRefused) {
  const Surface square = FlatStrip(2, 2);
  CornerUv uv;
  for (const Index v : square.triangulation.vertex) {
    uv.value.emplace_back(-square.position[v].x(), square.position[v].y());
  }
  SurfaceMap map;
  const IntrinsicTriangulation same = {square.triangulation, MeasureEdgeLengths(square), {}, {}};
  const Status status = DrawExactDisk(square.triangulation, same, uv, {}, 1000, &map);
  EXPECT_EQ(status.code(), StatusCode::kUnrepresentable);
  EXPECT_THAT(status.message(), testing::HasSubstr("8 triangles"));
  EXPECT_FALSE(map.exact_map);
}

TEST(FacesBeforeSplit, TheirPartsFillThem) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 300);
  const Triangulation& t = surface.triangulation;
  std::vector<bool> edges(t.num_edges(), false);
  for (Index e = 0; e < t.num_edges(); e += 2) edges[e] = true;
  const Surface split = SplitEdges(surface, edges);
  const std::vector<Index> before = FacesBeforeSplit(t, edges);
  ASSERT_EQ(before.size(), static_cast<std::size_t>(split.triangulation.num_faces()));
  const auto area = [](const Surface& of, Index f) {
    const auto at = [&](Index k) { return of.position[of.triangulation.vertex[3 * f + k]]; };
    return (at(1) - at(0)).cross(at(2) - at(0)).norm();
  };
  std::vector<double> parts(t.num_faces(), 0);
  for (Index f = 0; f < split.triangulation.num_faces(); ++f) parts[before[f]] += area(split, f);
  for (Index f = 0; f < t.num_faces(); ++f) EXPECT_NEAR(parts[f], area(surface, f), 1e-12);
}

}  // namespace
}  // namespace cirque
