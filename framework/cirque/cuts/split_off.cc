#include "cirque/cuts/split_off.h"

namespace cirque {

Cut SplitOff(const Triangulation& t, const Cut& given, const std::vector<Index>& faces) {
  const Triangulation open = CutOpen(t, given);
  const Patches patches = ConnectedPatches(open);
  std::vector<bool> apart(t.num_faces(), false);
  for (const Index f : faces) apart[f] = true;
  std::vector<bool> whole(patches.count, true);
  for (Index f = 0; f < t.num_faces(); ++f) {
    if (!apart[f]) whole[patches.of_face[f]] = false;
  }
  Cut cut = given;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (open.twin[h] == kNone) continue;
    const Index f = Triangulation::Face(h), g = Triangulation::Face(open.twin[h]);
    if (apart[f] != apart[g] || whole[patches.of_face[f]]) cut.edge[t.edge[h]] = true;
  }
  return cut;
}

}  // namespace cirque
