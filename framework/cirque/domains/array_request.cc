#include "cirque/domains/array_request.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/cuts/shortest_path.h"

namespace cirque {
namespace {

/// What a map of a surface is asked for, in the surface's own vertices.
class RequestMaker {
 public:
  RequestMaker(const MapOptions& options, Index num_vertices, const Surface& surface)
      : options_(options), surface_vertex_(num_vertices, kNone), surface_(surface) {
    for (Index v = 0; v < t().num_vertices; ++v) {
      if (surface.soup_vertex[v] != kNone) surface_vertex_[surface.soup_vertex[v]] = v;
    }
  }

  StatusOr<MapRequest> Make() {
    MapRequest request;
    request.domain = options_.domain;
    request.options = options_.options;
    request.options.exact |= options_.exact;
    request.shape = options_.shape;
    for (Index* v : {&request.shape.centre, &request.shape.angle_zero, &request.shape.pole}) {
      if (*v != kNone) *v = Vertex(*v);
    }
    for (Index& v : request.shape.corners) v = Vertex(v);
    AddTargets(&request);
    AddCut(&request);
    return status_.ok() ? StatusOr<MapRequest>(std::move(request)) : status_;
  }

 private:
  const Triangulation& t() const { return surface_.triangulation; }

  void Refuse(const std::string& why) {
    if (status_.ok()) status_ = Status::InvalidInput(why);
  }

  /// 0, and an error, for what is no vertex.
  Index Vertex(Index v) {
    const auto count = static_cast<Index>(surface_vertex_.size());
    if (v >= 0 && v < count && surface_vertex_[v] != kNone) return surface_vertex_[v];
    Refuse(fmt::format("no face has vertex {}; there are vertices 0 to {}", v, count - 1));
    return 0;
  }

  void AddTargets(MapRequest* request) {
    const bool by_name = options_.options.AsksForCones();
    const int ways = (options_.cones.empty() ? 0 : 1) + (options_.angle_sums.empty() ? 0 : 1);
    if (ways + (by_name ? 1 : 0) > 1) {
      return Refuse("give the cones one way: by a heuristic, by their angles or by all angle sums");
    }
    if (!options_.angle_sums.empty()) return AddAngleSums(request);
    if (ways == 0) return;
    std::vector<Cone> cones = options_.cones;
    for (Cone& cone : cones) cone.vertex = Vertex(cone.vertex);
    StatusOr<ConeTargets> targets = TargetsAtCones(t(), cones);
    if (!targets.ok()) return Refuse(targets.status().message());
    request->targets = *std::move(targets);
  }

  void AddAngleSums(MapRequest* request) {
    if (options_.angle_sums.size() != surface_vertex_.size()) {
      return Refuse(fmt::format("{} angle sums for {} vertices", options_.angle_sums.size(),
                                surface_vertex_.size()));
    }
    ConeTargets targets;
    targets.lower.reserve(t().num_vertices);
    for (Index v = 0; v < t().num_vertices; ++v) {
      const Index of_arrays = surface_.soup_vertex[v];
      targets.lower.push_back(of_arrays == kNone ? 2 * kPi : options_.angle_sums[of_arrays]);
    }
    targets.upper = targets.lower;
    request->targets = std::move(targets);
  }

  void AddCut(MapRequest* request) {
    if (options_.cut.empty() && options_.cut_paths.empty()) return;
    Cut cut;
    if (!options_.cut_paths.empty()) {
      std::vector<std::pair<Index, Index>> ends;
      for (const auto& [a, b] : options_.cut_paths) ends.emplace_back(Vertex(a), Vertex(b));
      StatusOr<Cut> paths = CutAlongShortestPaths(t(), MeasureEdgeLengths(surface_).value, ends);
      if (!paths.ok()) return Refuse(paths.status().message());
      cut = *std::move(paths);
    }
    cut.edge.resize(t().num_edges(), false);
    AddCutEdges(&cut);
    request->cut = std::move(cut);
  }

  void AddCutEdges(Cut* cut) {
    std::vector<std::pair<std::pair<Index, Index>, Index>> wanted;
    for (std::size_t i = 0; i < options_.cut.size(); ++i) {
      wanted.push_back(
          {std::minmax({Vertex(options_.cut[i].first), Vertex(options_.cut[i].second)}),
           static_cast<Index>(i)});
    }
    std::sort(wanted.begin(), wanted.end());
    std::vector<bool> found(wanted.size(), false);
    for (Index e = 0; e < t().num_edges(); ++e) {
      const Index h = t().edge_halfedge[e];
      const std::pair<Index, Index> ends = std::minmax({t().Tail(h), t().Tip(h)});
      auto it = std::lower_bound(wanted.begin(), wanted.end(), std::pair(ends, Index{0}));
      for (; it != wanted.end() && it->first == ends; ++it) {
        cut->edge[e] = found[it->second] = true;
      }
    }
    const auto missing = std::find(found.begin(), found.end(), false);
    if (missing == found.end()) return;
    const auto& [a, b] = options_.cut[missing - found.begin()];
    Refuse(fmt::format("cut: no edge joins the vertices {} and {}", a, b));
  }

  const MapOptions& options_;
  std::vector<Index> surface_vertex_;  ///< of the arrays' vertices; the last of several
  const Surface& surface_;
  Status status_;
};

}  // namespace

StatusOr<MapRequest> RequestOf(const MapOptions& options, Index num_vertices,
                               const Surface& surface) {
  return RequestMaker(options, num_vertices, surface).Make();
}

}  // namespace cirque
