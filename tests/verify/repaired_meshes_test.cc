// What the program makes of meshes that are no surface, held against what the judge does.
#include <random>

#include <gtest/gtest.h>

#include "cirque/mesh/preflight.h"
#include "cirque/verify/map_check.h"

namespace cirque::verify {
namespace {

/// Triangles at random on the points of a small grid: some have no area or repeat a vertex or each
/// other, edges have many faces, and fans meet in vertices.
PolygonSoup RandomTriangles(std::mt19937* random) {
  std::uniform_int_distribution<Index> vertex(0, 8), faces(1, 16);
  PolygonSoup soup;
  for (int v = 0; v < 9; ++v) soup.position.emplace_back(v % 3, v / 3, (v * v) % 2);
  const Index count = faces(*random);
  for (Index f = 1; f <= count; ++f) {
    for (int k = 0; k < 3; ++k) soup.corner.push_back(vertex(*random));
    soup.first_corner.push_back(3 * f);
  }
  return soup;
}

/// Every triangle by itself, upright.
CornerUv Scattered(const cirque::Surface& surface, double from) {
  CornerUv uv;
  for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
    uv.value.insert(uv.value.end(), {{from + 2 * f, 0}, {from + 2 * f + 1, 0}, {from + 2 * f, 1}});
  }
  return uv;
}

TEST(RepairedMeshes, OfRandomTrianglesProgramAndJudgeMakeTheSameSurface) {
  std::mt19937 random(7);
  int judged = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    SCOPED_TRACE(trial);
    const PolygonSoup in = RandomTriangles(&random);
    PreflightReport report;
    RepairSummary summary;
    const auto components = SurfacesOf(in, {}, &report, &summary);
    if (!components.ok()) continue;  // no face has an area
    std::vector<CornerUv> uvs;
    std::vector<MappedSurface> mapped;
    bool two_sided = true;
    for (const MeshComponent& component : *components) {
      two_sided = two_sided && component.surface.ok();
      if (!component.surface.ok()) continue;
      uvs.push_back(Scattered(*component.surface, 100. * static_cast<double>(uvs.size())));
    }
    for (std::size_t i = 0; two_sided && i < uvs.size(); ++i) {
      mapped.push_back({*(*components)[i].surface, uvs[i]});
    }
    const auto verdict = VerifyMap(in, AttachUv(in, mapped), {});
    if (!two_sided) {
      EXPECT_FALSE(verdict.ok() && verdict->valid());
      continue;
    }
    ASSERT_TRUE(verdict.ok()) << verdict.status().message();
    EXPECT_TRUE(verdict->valid()) << verdict->Verdict();
    EXPECT_EQ(static_cast<Index>(verdict->set_aside.size()), summary.num_set_aside());
    ++judged;
  }
  EXPECT_GT(judged, 1000);
}

}  // namespace
}  // namespace cirque::verify
