// Exact maps to the disk with round holes: judged by the independent judge, their loops on circles.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/exact_mesh.h"
#include "cirque/verify/judge_map.h"

#include "tests/common/domain_maps.h"
#include "tests/common/exact_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

MapRequest ExactRequest() {
  MapRequest request = RequestFor("round_holes");
  request.options.exact = true;
  return request;
}

Surface Stretched(const Surface& surface, double by) {
  return Moved(surface, [by](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x.x(), by * x.y() + 0.3 * x.x(), x.z());
  });
}

/// The judge's word of the exact map as one to the disk with round holes.
std::string Verdict(const Surface& surface, const ExactMap& map) {
  const ExactMesh exact = RefineByExactMap(TrianglesOf(surface), surface, map);
  PolygonSoup bare = exact.mesh;
  bare.texture.clear();
  bare.corner_texture.clear();
  JudgeOptions options;
  options.domain = "round_holes";
  const auto verdict = JudgeMap(bare, exact.mesh, options);
  EXPECT_TRUE(verdict.ok()) << verdict.status().message();
  return verdict.ok() ? verdict->verdict : "";
}

TEST(ExactRoundHoles, OfAPlateIsAcceptedAndHasNoSeam) {
  const Surface plate = Stretched(GeneratedSurface("plate_with_holes", 1500), 2);
  for (const PatternKind pattern : {PatternKind::kCircle, PatternKind::kEquivalence}) {
    MapRequest request = ExactRequest();
    request.options.pattern = pattern;
    const SurfaceMap map = MustMap(plate, request);
    ASSERT_TRUE(map.exact_map);
    EXPECT_GT(map.certificate.exact_map->exact_crossings, 50);
    EXPECT_EQ(map.exact_map->uv.size(), map.exact_map->point.size());
    ExpectExactMapIsAccepted(plate, map);
    EXPECT_THAT(Verdict(plate, *map.exact_map), testing::StartsWith("valid (injective)"));
    EXPECT_LT(map.certificate.exact_map->exact_quasi_conformal_mean, 1.5);
  }
}

TEST(ExactRoundHoles, TheJudgeRefusesAVertexOffItsCircle) {
  const Surface plate = Stretched(GeneratedSurface("plate_with_holes", 1000), 2);
  const SurfaceMap map = MustMap(plate, ExactRequest());
  ASSERT_TRUE(map.exact_map);
  ExactMap moved = *map.exact_map;
  const Index on_boundary = plate.triangulation.Tail(BoundaryLoops(plate.triangulation)[0][0]);
  for (std::size_t c = 0; c < moved.corner.size(); ++c) {
    if (moved.corner[c] == on_boundary) {
      moved.uv[moved.corner_uv[c]] = map.exact_map->uv[moved.corner_uv[c]] * (1 - 1e-6);
    }
  }
  EXPECT_THAT(Verdict(plate, moved), testing::HasSubstr("INVALID"));
}

// Chords of the outer boundary are split for the solve; the pieces lie in the mesh's own faces.
TEST(ExactRoundHoles, OfChordsLiesInTheInputsFaces) {
  // The outer sides, n squares long, have ears at their corners.
  PolygonSoup soup;
  constexpr int n = 9;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) soup.position.emplace_back(i, 1.5 * j + 0.4 * i, 0);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      if (i == 4 && j == 4) continue;
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      for (const int v : {a, b, d, b, c, d}) soup.corner.push_back(v);
      for (int k = 1; k <= 2; ++k) {
        soup.first_corner.push_back(static_cast<Index>(soup.corner.size()) - 6 + 3 * k);
      }
    }
  }
  const Surface frame = SurfaceOf(soup);
  const SurfaceMap map = MustMap(frame, ExactRequest());
  ASSERT_TRUE(map.exact_map);
  EXPECT_EQ(map.certificate.round_holes->chords, 2);
  ExpectExactMapIsAccepted(frame, map);
  EXPECT_THAT(Verdict(frame, *map.exact_map), testing::StartsWith("valid (injective)"));
  for (const Index f : map.exact_map->face_of_input) EXPECT_LT(f, frame.triangulation.num_faces());
  EXPECT_GE(map.certificate.exact_map->exact_faces_worst,
            map.certificate.exact_map->exact_faces_ratio);
}

}  // namespace
}  // namespace cirque
