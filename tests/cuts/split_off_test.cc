#include "cirque/cuts/split_off.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/mesh/surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

Cut NoCut(const Triangulation& t) { return {std::vector<bool>(t.num_edges(), false)}; }

Patches PatchesAfter(const Triangulation& t, const Cut& cut) {
  return ConnectedPatches(CutOpen(t, cut));
}

TEST(SplitOff, NoPatchHasFacesOfBothKinds) {
  const Triangulation t = FlatStrip(6, 4).triangulation;
  const std::vector<Index> faces = {3, 20, 21, 22};
  const Patches patches = PatchesAfter(t, SplitOff(t, NoCut(t), faces));
  std::vector<bool> apart(t.num_faces(), false);
  for (const Index f : faces) apart[f] = true;
  for (Index f = 0; f < t.num_faces(); ++f) {
    for (Index g = 0; g < t.num_faces(); ++g) {
      if (patches.of_face[f] != patches.of_face[g]) continue;
      EXPECT_EQ(apart[f], apart[g]) << f << " " << g;
    }
  }
  EXPECT_EQ(patches.of_face[20], patches.of_face[21]) << "neighbours stay together";
  EXPECT_NE(patches.of_face[3], patches.of_face[20]);
}

TEST(SplitOff, APatchOfNothingElseFallsApart) {
  const Triangulation t = FlatStrip(6, 4).triangulation;
  const std::vector<Index> faces = {20, 21};
  const Cut once = SplitOff(t, NoCut(t), faces), again = SplitOff(t, once, faces);
  const Patches patches = PatchesAfter(t, again);
  EXPECT_EQ(patches.count, PatchesAfter(t, once).count + 1);
  EXPECT_NE(patches.of_face[20], patches.of_face[21]);
  EXPECT_EQ(SplitOff(t, again, faces).edge, again.edge) << "nothing is left to be opened";
}

TEST(SplitOff, OpensNothingWithoutFacesAndClosesNothing) {
  const Triangulation t = FlatStrip(3, 3).triangulation;
  EXPECT_TRUE(SplitOff(t, NoCut(t), {}).IsEmpty());
  Cut given = NoCut(t);
  given.edge[t.edge[0]] = true;
  const Cut cut = SplitOff(t, given, {5});
  for (Index e = 0; e < t.num_edges(); ++e) EXPECT_GE(cut.edge[e], given.edge[e]);
}

}  // namespace
}  // namespace cirque
