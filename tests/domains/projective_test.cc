// The projective interpolation of conformal equivalence: one projective map on every piece of the
// surface that lies in one triangle of either triangulation, circumcircles to circumcircles.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/domains/exact_mesh.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A flat patch that is Delaunay, so that all flips are Ptolemy's, with narrow and wide cones.
struct Coned {
  Surface surface;
  MapRequest request;
};

Coned ConedPatch(PatternKind pattern = PatternKind::kEquivalence) {
  Coned coned{GeneratedSurface("flat_delaunay_patch", 300), {}};
  const Triangulation& t = coned.surface.triangulation;
  coned.request.options.exact = true;
  coned.request.options.strict = true;
  coned.request.options.pattern = pattern;
  ConeTargets targets = FreeBoundaryTargets(t);
  const std::vector<bool> boundary = BoundaryVertices(t);
  std::vector<Index> inner;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (!boundary[v]) inner.push_back(v);
  }
  for (std::size_t k = 1; k < 8; ++k) {
    const Index cone = inner[k * inner.size() / 8];
    targets.lower[cone] = targets.upper[cone] = (k % 2 == 0 ? 0.5 : 3.5) * kPi;
  }
  coned.request.targets = targets;
  return coned;
}

Eigen::Vector3d Homogeneous(const ExactMap& map, Index corner) {
  return std::exp(map.log_weight[map.corner[corner]]) * map.uv[map.corner_uv[corner]].homogeneous();
}

Eigen::Vector3d Barycentric(const Triangulation& t, const ExactMap& map, Index corner) {
  const Index face = map.face_of_input[Triangulation::Face(corner)];
  return InFace(t, map.point[map.corner[corner]], face);
}

/// How far the fourth and later points of a piece are from the projective map that three of them
/// say, relative to their size.
double OffProjective(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& points) {
  double largest = 0, off = 0;
  Eigen::Matrix3d from = Eigen::Matrix3d::Identity(), to = from;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        Eigen::Matrix3d x, h;
        x << points[i].first, points[j].first, points[k].first;
        h << points[i].second, points[j].second, points[k].second;
        if (std::abs(x.determinant()) <= largest) continue;
        largest = std::abs(x.determinant());
        from = x;
        to = h;
      }
    }
  }
  if (largest < 1e-3) return 0;
  const Eigen::Matrix3d projective = to * from.inverse();
  for (const auto& [x, h] : points) {
    off = std::max(off, (projective * x - h).norm() / h.norm());
  }
  return off;
}

TEST(Projective, IsOneProjectiveMapOnEveryPieceOfBothTriangulations) {
  const Coned coned = ConedPatch();
  const auto map = MapSurface(coned.surface, coned.request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ASSERT_EQ(map->certificate.triangulation->flips, map->certificate.equivalence->ptolemy_flips);
  ASSERT_GT(map->certificate.equivalence->ptolemy_flips, 10);
  const ExactMap& exact = *map->exact_map;
  ASSERT_EQ(exact.log_weight.size(), exact.point.size());
  const Triangulation& t = coned.surface.triangulation;
  std::map<std::pair<Index, Index>, std::map<Index, Index>> pieces;  // corners by their points
  for (Index c = 0; c < 3 * exact.num_triangles(); ++c) {
    const Index face = Triangulation::Face(c);
    pieces[{exact.face_of_input[face], exact.face_of_solved[face]}][exact.corner[c]] = c;
  }
  int of_four = 0;
  for (const auto& [faces, corners] : pieces) {
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> points;
    for (const auto& [point, c] : corners) {
      points.emplace_back(Barycentric(t, exact, c), Homogeneous(exact, c));
    }
    if (points.size() < 4) continue;
    ++of_four;
    EXPECT_LT(OffProjective(points), 1e-7);
  }
  EXPECT_GT(of_four, 5);
}

/// The centre of the circle through three points.
Eigen::Vector2d Circumcentre(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                             const Eigen::Vector2d& c) {
  Eigen::Matrix2d sides;
  sides << (b - a).transpose(), (c - a).transpose();
  return a + sides.inverse() *
                 Eigen::Vector2d(0.5 * (b - a).squaredNorm(), 0.5 * (c - a).squaredNorm());
}

TEST(Projective, TakesCircumcirclesToCircumcirclesWhereNoEdgeWasFlipped) {
  const Coned coned = ConedPatch();
  const auto map = MapSurface(coned.surface, coned.request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  const ExactMap& exact = *map->exact_map;
  const Triangulation& t = coned.surface.triangulation;
  int whole = 0;
  for (Index c = 0; c < 3 * exact.num_triangles(); c += 3) {
    Eigen::Vector2d at[3], image[3];
    Eigen::Vector3d homogeneous[3];
    bool vertices = true;
    for (int k = 0; k < 3; ++k) {
      const Index point = exact.corner[c + k];
      vertices = vertices && point < t.num_vertices;
      if (!vertices) break;
      at[k] = coned.surface.position[point].head<2>();
      image[k] = exact.uv[exact.corner_uv[c + k]];
      homogeneous[k] = Homogeneous(exact, c + k);
    }
    if (!vertices) continue;
    ++whole;
    const Eigen::Vector2d centre = Circumcentre(at[0], at[1], at[2]);
    const Eigen::Vector2d image_centre = Circumcentre(image[0], image[1], image[2]);
    const double radius = (image[0] - image_centre).norm();
    for (int i = 1; i < 12; ++i) {
      const Eigen::Vector2d p =
          centre + Eigen::Rotation2Dd(0.5 * i) * Eigen::Vector2d(at[0] - centre);
      Eigen::Matrix3d corners;
      corners << at[0].homogeneous(), at[1].homogeneous(), at[2].homogeneous();
      const Eigen::Vector3d x = corners.inverse() * p.homogeneous();
      const Eigen::Vector3d h =
          x[0] * homogeneous[0] + x[1] * homogeneous[1] + x[2] * homogeneous[2];
      EXPECT_NEAR((h.hnormalized() - image_centre).norm(), radius, 1e-6 * radius);
    }
  }
  EXPECT_GT(whole, 100);
}

/// Also where the surface's own flips come first.
TEST(Projective, IsContinuousAcrossEdgesOfTheInput) {
  const Surface blob =
      Moved(GeneratedSurface("blob", 400), [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        return {x.x(), x.y(), 4 * x.z()};
      });
  MapRequest request;
  request.options.exact = true;
  request.options.strict = true;
  request.options.pattern = PatternKind::kEquivalence;
  const auto map = MapSurface(blob, request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  const ExactMesh exact = RefineByExactMap(TrianglesOf(blob), blob, *map->exact_map);
  const std::vector<Eigen::Vector3d> texture = HomogeneousTexture(exact);
  ASSERT_EQ(texture.size(), exact.mesh.texture.size());
  std::map<std::pair<Index, Index>, std::vector<Index>> sides;  // triangles' sides by their points
  const auto& corner = exact.mesh.corner;
  for (Index c = 0; c < static_cast<Index>(corner.size()); ++c) {
    sides[std::minmax(corner[c], corner[Triangulation::Next(c)])].push_back(c);
  }
  int crossed = 0;
  const auto at = [&](Index c) { return texture[exact.mesh.corner_texture[c]]; };
  for (const auto& [points, corners] : sides) {
    ASSERT_EQ(corners.size(), 2u);
    const Index a = corners[0], b = corners[1];
    if (exact.polygon[a / 3] == exact.polygon[b / 3]) continue;
    const Index to_a = Triangulation::Next(a), to_b = Triangulation::Next(b);
    if (exact.mesh.corner_texture[a] != exact.mesh.corner_texture[to_b]) continue;  // a seam
    if (exact.mesh.corner_texture[to_a] != exact.mesh.corner_texture[b]) continue;
    ++crossed;
    for (const double s : {0.25, 0.5, 0.9}) {
      const Eigen::Vector3d one = (1 - s) * at(a) + s * at(to_a);
      const Eigen::Vector3d other = s * at(b) + (1 - s) * at(to_b);
      EXPECT_LT((one.hnormalized() - other.hnormalized()).norm(), 1e-12);
    }
  }
  EXPECT_GT(crossed, 400);
  EXPECT_EQ(*std::max_element(exact.weight.begin(), exact.weight.end()), 1);
  EXPECT_GT(*std::min_element(exact.weight.begin(), exact.weight.end()), 0);
}

TEST(Projective, CirclePatternsHaveNoWeights) {
  Coned coned = ConedPatch(PatternKind::kCircle);
  const auto map = MapSurface(coned.surface, coned.request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_TRUE(map->exact_map->log_weight.empty());
  const ExactMesh exact =
      RefineByExactMap(TrianglesOf(coned.surface), coned.surface, *map->exact_map);
  EXPECT_TRUE(HomogeneousTexture(exact).empty());
}

}  // namespace
}  // namespace cirque
