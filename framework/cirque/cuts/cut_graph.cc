#include "cirque/cuts/cut_graph.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/count.h"
#include "cirque/core/grouping.h"
#include "cirque/core/text.h"
#include "cirque/cuts/shortest_path.h"
#include "cirque/mesh/holes.h"

namespace cirque {
namespace {

/// Opens the path from a node to its source, as far as it is not open yet.
void OpenPath(const EdgeGraph& graph, const ShortestPathForest& forest, Index node, Cut* cut) {
  while (forest.edge[node] != kNone && !cut->edge[forest.edge[node]]) {
    const Index e = forest.edge[node];
    cut->edge[e] = true;
    node = graph.Across(e, node);
  }
}

/// Contracts every boundary loop, and the cut, to a node.
std::vector<Index> ContractLoopsAndCut(const Triangulation& t, const Cut& cut) {
  DisjointSets sets(t.num_vertices);
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    if (t.IsBoundaryEdge(e) || cut.edge[e]) sets.Unite(t.Tail(h), t.Tip(h));
  }
  std::vector<Index> node(t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) node[v] = sets.Find(v);
  return node;
}

/// The edges among `edges` in the order of the length of the loop, or path between two sources,
/// that each closes.
std::vector<Index> SortByPathLength(const EdgeGraph& graph, const Eigen::VectorXd& cost,
                                    const ShortestPathForest& forest, std::vector<Index> edges) {
  const auto length = [&](Index e) {
    const auto [a, b] = graph.Ends(e);
    return forest.distance[a] + cost[e] + forest.distance[b];
  };
  std::vector<std::pair<double, Index>> keyed;
  keyed.reserve(edges.size());
  for (const Index e : edges) keyed.emplace_back(length(e), e);
  std::sort(keyed.begin(), keyed.end());
  std::transform(keyed.begin(), keyed.end(), edges.begin(), [](const auto& k) { return k.second; });
  return edges;
}

/// The edges neither in the tree nor in a maximum spanning tree of the dual: two a handle.
std::vector<Index> HandleEdges(const Triangulation& t, const EdgeGraph& graph,
                               const Eigen::VectorXd& cost, const ShortestPathForest& tree) {
  std::vector<bool> in_tree(t.num_edges(), false);
  for (const Index e : tree.edge) {
    if (e != kNone) in_tree[e] = true;
  }
  std::vector<Index> candidates;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!in_tree[e] && !t.IsBoundaryEdge(e)) candidates.push_back(e);
  }
  candidates = SortByPathLength(graph, cost, tree, std::move(candidates));
  DisjointSets faces(t.num_faces());
  std::vector<Index> left_over;
  for (auto e = candidates.rbegin(); e != candidates.rend(); ++e) {
    const Index h = t.edge_halfedge[*e];
    const Index a = Triangulation::Face(h), b = Triangulation::Face(t.twin[h]);
    if (faces.Find(a) == faces.Find(b)) {
      left_over.push_back(*e);
    } else {
      faces.Unite(a, b);
    }
  }
  return left_over;
}

/// Closes the branch of the cut that ends, without need, at the node.
void PruneBranch(const EdgeGraph& graph, Index node, Cut* cut) {
  while (true) {
    Index ends = 0, last = kNone;
    graph.ForEachEdgeAt(node, [&](Index e) {
      if (!cut->edge[e]) return;
      ++ends;
      last = e;
    });
    if (ends != 1) return;
    cut->edge[last] = false;
    node = graph.Across(last, node);
  }
}

/// Opens the handles of a surface whose boundary loops count as points.
void OpenHandles(const Triangulation& t, const Eigen::VectorXd& cost, Index root_vertex, Cut* cut) {
  const EdgeGraph graph(t, ContractLoopsAndCut(t, *cut));
  const Index root = graph.Node(root_vertex);
  const ShortestPathForest tree = GrowShortestPaths(graph, cost, {root});
  for (const Index e : HandleEdges(t, graph, cost, tree)) {
    cut->edge[e] = true;
    for (const Index n : graph.Ends(e)) OpenPath(graph, tree, n, cut);
  }
  PruneBranch(graph, root, cut);
}

/// The nodes that the cut has to join: loops, cones and the cut so far.
std::vector<Index> Terminals(const Triangulation& t, const EdgeGraph& graph,
                             const std::vector<Index>& cones, const Cut& cut) {
  std::vector<Index> terminals;
  for (const Index v : cones) terminals.push_back(graph.Node(v));
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (t.IsBoundaryEdge(e) || cut.edge[e]) terminals.push_back(graph.Ends(e)[0]);
  }
  std::sort(terminals.begin(), terminals.end());
  terminals.erase(std::unique(terminals.begin(), terminals.end()), terminals.end());
  return terminals;
}

/// Joins the terminals by a minimum spanning tree of the shortest paths between them.
void JoinTerminals(const EdgeGraph& graph, const Eigen::VectorXd& cost,
                   const std::vector<Index>& terminals, Cut* cut) {
  const ShortestPathForest forest = GrowShortestPaths(graph, cost, terminals);
  const auto sources = [&](Index e) {
    return std::pair(forest.source[graph.Ends(e)[0]], forest.source[graph.Ends(e)[1]]);
  };
  std::vector<Index> bridges;
  for (Index e = 0; e < graph.num_edges(); ++e) {
    if (sources(e).first != sources(e).second && std::isfinite(cost[e])) bridges.push_back(e);
  }
  DisjointSets joined(graph.num_nodes());
  for (const Index e : SortByPathLength(graph, cost, forest, std::move(bridges))) {
    const auto [a, b] = sources(e);
    if (joined.Find(a) == joined.Find(b)) continue;
    joined.Unite(a, b);
    cut->edge[e] = true;
    for (const Index n : graph.Ends(e)) OpenPath(graph, forest, n, cut);
  }
}

Status RequireCones(const Triangulation& t, const std::vector<Index>& cones) {
  std::vector<int> unknown;
  for (const Index v : cones) {
    if (v < 0 || v >= t.num_vertices) unknown.push_back(v);
  }
  if (unknown.empty()) return Status();
  return Status::InvalidInput(
      fmt::format("cones at vertices {} (0-based), but the surface has {} vertices",
                  IdList(unknown), t.num_vertices));
}

}  // namespace

StatusOr<Cut> CutGraph(const Triangulation& t, const Eigen::VectorXd& edge_cost,
                       const std::vector<Index>& cones) {
  CHECK_EQ(edge_cost.size(), t.num_edges());
  if (Status s = RequireCones(t, cones); !s.ok()) return s;
  Cut cut = {std::vector<bool>(t.num_edges(), false)};
  const auto loops = static_cast<Index>(BoundaryLoops(t).size());
  const bool has_handles = EulerCharacteristic(t) + loops < 2;
  if (loops == 1 && !has_handles && cones.empty()) return cut;
  if (has_handles) OpenHandles(t, edge_cost, cones.empty() ? 0 : cones.front(), &cut);
  const EdgeGraph graph(t, ContractLoopsAndCut(t, cut));
  const std::vector<Index> terminals = Terminals(t, graph, cones, cut);
  if (loops == 0 && !has_handles && terminals.size() < 2) {
    return Status::InvalidInput(
        "a sphere without at least two cones cannot be cut to a disk through its cones: give cones "
        "(a flat metric needs three), or remove a face");
  }
  JoinTerminals(graph, edge_cost, terminals, &cut);
  return cut;
}

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
    text +=
        fmt::format("{}the patch of face {} (0-based; {}) is not a disk: genus {}, {}",
                    text.empty() ? "" : "; ", p.first_face, Count(p.faces, "face"),
                    (2 - p.euler_characteristic - p.loops) / 2, Count(p.loops, "boundary loop"));
  }
  if (wrong > kShown) text += fmt::format("; and {}", Count(wrong - kShown, "more patch"));
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

std::vector<Index> ConeVertices(const std::vector<bool>& boundary, const ConeTargets& targets) {
  std::vector<Index> cones;
  for (Index v = 0; v < static_cast<Index>(boundary.size()); ++v) {
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

namespace {

/// A patch of a surface that was opened along a cut, on its own.
struct OpenedPatch {
  SubTriangulation part;
  Eigen::VectorXd cost;
  std::vector<Index> cones;  ///< inside
};

OpenedPatch TakePatch(const Triangulation& t, const Eigen::VectorXd& cost,
                      const Triangulation& open, const std::vector<bool>& keep,
                      const std::vector<bool>& is_cone) {
  OpenedPatch patch{KeepFaces(open, keep), {}, {}};
  const Triangulation& part = patch.part.triangulation;
  patch.cost.resize(part.num_edges());
  std::vector<bool> inside(part.num_vertices, false);
  for (Index h = 0; h < part.num_halfedges(); ++h) {
    patch.cost[part.edge[h]] = cost[t.edge[patch.part.Halfedge(h)]];
    if (is_cone[t.vertex[patch.part.Halfedge(h)]]) inside[part.vertex[h]] = true;
  }
  const std::vector<bool> on_boundary = BoundaryVertices(part);
  for (Index v = 0; v < part.num_vertices; ++v) {
    if (inside[v] && !on_boundary[v]) patch.cones.push_back(v);
  }
  return patch;
}

}  // namespace

StatusOr<Cut> CompleteCut(const Triangulation& t, const Eigen::VectorXd& edge_cost,
                          const Cut& given, const std::vector<Index>& cones) {
  if (Status s = RequireCones(t, cones); !s.ok()) return s;
  const Triangulation open = CutOpen(t, given);
  const Patches patches = ConnectedPatches(open);
  if (patches.count == 1 && given.IsEmpty()) return CutGraph(t, edge_cost, cones);
  if (CheckCut(t, given, cones).ok()) return given;
  std::vector<bool> is_cone(t.num_vertices, false), keep(t.num_faces());
  for (const Index v : cones) is_cone[v] = true;
  Cut cut = given;
  for (Index p = 0; p < patches.count; ++p) {
    for (Index f = 0; f < t.num_faces(); ++f) keep[f] = patches.of_face[f] == p;
    const OpenedPatch patch = TakePatch(t, edge_cost, open, keep, is_cone);
    const StatusOr<Cut> further = CutGraph(patch.part.triangulation, patch.cost, patch.cones);
    if (!further.ok()) return further.status();
    for (Index h = 0; h < patch.part.triangulation.num_halfedges(); ++h) {
      if (further->edge[patch.part.triangulation.edge[h]]) {
        cut.edge[t.edge[patch.part.Halfedge(h)]] = true;
      }
    }
  }
  return cut;
}

}  // namespace cirque
