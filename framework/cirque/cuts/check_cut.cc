#include "cirque/cuts/check_cut.h"

#include <string>

#include <fmt/format.h>

#include "cirque/core/text.h"

namespace cirque {
namespace {

struct PatchTopology {
  Index first_face = kNone, faces = 0, euler_characteristic = 0, loops = 0;

  bool IsDisk() const { return euler_characteristic == 1 && loops == 1; }
};

std::vector<PatchTopology> MeasurePatches(const Triangulation& open) {
  const Patches patches = ConnectedPatches(open);
  std::vector<PatchTopology> topology(patches.count);
  const auto of_halfedge = [&](Index h) -> PatchTopology& {
    return topology[patches.of_face[Triangulation::Face(h)]];
  };
  for (Index f = 0; f < open.num_faces(); ++f) {
    PatchTopology& patch = topology[patches.of_face[f]];
    if (patch.faces == 0) patch.first_face = f;
    ++patch.faces;
    ++patch.euler_characteristic;
  }
  for (const Index h : open.edge_halfedge) --of_halfedge(h).euler_characteristic;
  std::vector<bool> counted(open.num_vertices, false);
  for (Index c = 0; c < open.num_halfedges(); ++c) {
    if (counted[open.vertex[c]]) continue;
    counted[open.vertex[c]] = true;
    ++of_halfedge(c).euler_characteristic;
  }
  for (const auto& loop : BoundaryLoops(open)) ++of_halfedge(loop.front()).loops;
  return topology;
}

/// What is wrong with the patches; empty when all are disks.
std::string DescribePatches(const std::vector<PatchTopology>& patches) {
  constexpr int kShown = 5;
  std::string text;
  int wrong = 0;
  for (const PatchTopology& p : patches) {
    if (p.IsDisk() || ++wrong > kShown) continue;
    text += fmt::format(
        "{}the patch of face {} (0-based; {} faces) is not a disk: genus {}, {} "
        "boundary loops",
        text.empty() ? "" : "; ", p.first_face, p.faces, (2 - p.euler_characteristic - p.loops) / 2,
        p.loops);
  }
  if (wrong > kShown) text += fmt::format("; and {} more patches", wrong - kShown);
  return text.empty() ? text : text + "; cut its handles open and join its loops by cuts";
}

std::vector<int> CoveredCones(const Triangulation& t, const Cut& cut,
                              const std::vector<Index>& cones) {
  std::vector<bool> open(t.num_vertices, false);
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    if (cut.edge[e] || t.IsBoundaryEdge(e)) open[t.Tail(h)] = open[t.Tip(h)] = true;
  }
  std::vector<int> covered;
  for (const Index v : cones) {
    if (!open[v]) covered.push_back(v);
  }
  return covered;
}

}  // namespace

std::vector<Index> ConeVertices(const Triangulation& t, const ConeTargets& targets) {
  const std::vector<bool> boundary = BoundaryVertices(t);
  std::vector<Index> cones;
  for (Index v = 0; v < t.num_vertices; ++v) {
    const bool flat = targets.lower[v] == 2 * kPi && targets.upper[v] == 2 * kPi;
    if (!boundary[v] && !flat) cones.push_back(v);
  }
  return cones;
}

Status CheckCut(const Triangulation& t, const Cut& cut, const std::vector<Index>& cones) {
  std::string problems = DescribePatches(MeasurePatches(CutOpen(t, cut)));
  const std::vector<int> covered = CoveredCones(t, cut, cones);
  if (!covered.empty()) {
    problems += fmt::format(
        "{}cones at vertices {} (0-based) lie inside their patches; lead the cut through them",
        problems.empty() ? "" : "; ", IdList(covered));
  }
  return problems.empty() ? Status() : Status::InvalidInput("invalid cut: " + problems);
}

}  // namespace cirque
