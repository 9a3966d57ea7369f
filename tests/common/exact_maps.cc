#include "tests/common/exact_maps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/exact_mesh.h"
#include "cirque/verify/judge_map.h"
#include "cirque/verify/refinement_check.h"

#include "tests/common/surfaces.h"

namespace cirque {

void ExpectExactMapIsAccepted(const Surface& surface, const SurfaceMap& map) {
  ASSERT_TRUE(map.exact_map);
  const PolygonSoup input = TrianglesOf(surface);
  const ExactMesh exact = RefineByExactMap(input, surface, *map.exact_map);
  EXPECT_EQ(exact.mesh.num_polygons(), map.certificate.exact_map->exact_triangles);
  const auto refinement = verify::CheckRefinement(input, exact.mesh, exact.polygon);
  ASSERT_TRUE(refinement.ok());
  EXPECT_THAT(refinement->errors, testing::IsEmpty());
  EXPECT_LE(refinement->area_error, 1e-12);
  PolygonSoup bare = exact.mesh;
  bare.texture.clear();
  bare.corner_texture.clear();
  const auto verdict =
      exact.sphere.empty() ? JudgeMap(bare, exact.mesh) : JudgeSphereMap(bare, exact.sphere);
  ASSERT_TRUE(verdict.ok()) << verdict.status().message();
  EXPECT_TRUE(verdict->valid) << verdict->verdict;
}

}  // namespace cirque
