#include <algorithm>

#include <gtest/gtest.h>

#include "cirque/mesh/holes.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(PunctureTest, LeavesADiskBoundedByTheLink) {
  const Surface sphere = GeneratedSurface("sphere", 300);
  const Triangulation& t = sphere.triangulation;
  for (const Index pole : {0, 17, t.num_vertices - 1}) {
    const PuncturedSurface disk = *Puncture(t, pole);
    const auto corners = static_cast<Index>(std::count(t.vertex.begin(), t.vertex.end(), pole));
    EXPECT_EQ(disk.pole, pole);
    EXPECT_EQ(static_cast<Index>(disk.link.size()), corners);
    EXPECT_EQ(disk.triangulation.num_faces(), t.num_faces() - corners);
    EXPECT_EQ(disk.triangulation.num_vertices, t.num_vertices - 1);
    EXPECT_EQ(EulerCharacteristic(disk.triangulation), 1);
    const auto loops = BoundaryLoops(disk.triangulation);
    ASSERT_EQ(loops.size(), 1u);
    std::vector<Index> boundary, link = disk.link;
    for (const Index h : loops[0]) boundary.push_back(disk.vertex[disk.triangulation.Tail(h)]);
    std::sort(boundary.begin(), boundary.end());
    std::sort(link.begin(), link.end());
    EXPECT_EQ(boundary, link);
  }
}

TEST(PunctureTest, KeepsCornersAndGluing) {
  const Surface blob = GeneratedSurface("blob", 300);
  const Triangulation& t = blob.triangulation;
  const PuncturedSurface disk = *Puncture(t, 5);
  for (Index h = 0; h < disk.triangulation.num_halfedges(); ++h) {
    const Index in_closed = 3 * disk.face[h / 3] + h % 3;
    EXPECT_EQ(disk.vertex[disk.triangulation.vertex[h]], t.vertex[in_closed]);
    const Index twin = disk.triangulation.twin[h];
    if (twin != kNone) {
      EXPECT_EQ(3 * disk.face[twin / 3] + twin % 3, t.twin[in_closed]);
    }
  }
}

TEST(PunctureTest, RefusesAStarThatIsNoDisk) {
  // Two triangles glued along all three sides: the star of any vertex is everything.
  const Triangulation pillow = NumberEdges(3, {0, 1, 2, 0, 2, 1}, {3, 5, 4, 0, 2, 1});
  EXPECT_EQ(Puncture(pillow, 0).status().code(), StatusCode::kInvalidInput);
}

}  // namespace
}  // namespace cirque
