#include "cirque/domains/component_requests.h"

#include <memory>
#include <utility>

#include "cirque/domains/atlas.h"
#include "cirque/intrinsic/loop_rotations.h"

namespace cirque {
namespace {

/// The share of one surface in a request for all of them, joined: from these numbers on.
class Share {
 public:
  Share(const Surface& surface, Index first_vertex, Index first_edge, Index first_face)
      : t_(surface.triangulation),
        first_vertex_(first_vertex),
        first_edge_(first_edge),
        first_face_(first_face) {}

  MapRequest Of(const MapRequest& all) const {
    MapRequest own = all;
    for (Index* v : {&own.shape.centre, &own.shape.angle_zero, &own.shape.pole}) *v = OwnVertex(*v);
    own.shape.corners.clear();
    for (const Index v : all.shape.corners) {
      if (OwnVertex(v) != kNone) own.shape.corners.push_back(OwnVertex(v));
    }
    own.targets.reset();
    if (all.targets) TakeTargets(*all.targets, &own);
    if (!own.targets) own.cone_rounding.reset();
    own.cut.reset();
    if (all.cut) TakeCut(*all.cut, &own);
    if (all.rotations) own.rotations = OwnRotations(*all.rotations);
    return own;
  }

 private:
  Index OwnVertex(Index v) const {
    const Index own = v - first_vertex_;
    return v != kNone && own >= 0 && own < t_.num_vertices ? own : kNone;
  }

  /// None where they are those of a surface that nothing is said of.
  void TakeTargets(const ConeTargets& all, MapRequest* own) const {
    const ConeTargets plain = FreeBoundaryTargets(t_);
    ConeTargets targets = plain;
    for (Index v = 0; v < t_.num_vertices; ++v) {
      targets.lower[v] = all.lower[first_vertex_ + v];
      targets.upper[v] = all.upper[first_vertex_ + v];
    }
    if (targets.lower != plain.lower || targets.upper != plain.upper) {
      own->targets = std::move(targets);
    }
  }

  void TakeCut(const Cut& all, MapRequest* own) const {
    const auto begin = all.edge.begin() + first_edge_;
    Cut cut{std::vector<bool>(begin, begin + t_.num_edges())};
    if (!cut.IsEmpty()) own->cut = std::move(cut);
  }

  std::shared_ptr<const PrescribedRotations> OwnRotations(const PrescribedRotations& all) const {
    PrescribedRotations own{{}, all.meet};
    for (LoopRotation loop : all.loops) {
      for (Index& h : loop.path.entered) h -= 3 * first_face_;
      const Index first = loop.path.entered.front();
      if (first >= 0 && first < t_.num_halfedges()) own.loops.push_back(std::move(loop));
    }
    return own.loops.empty() ? nullptr
                             : std::make_shared<const PrescribedRotations>(std::move(own));
  }

  const Triangulation& t_;
  Index first_vertex_, first_edge_, first_face_;
};

}  // namespace

StatusOr<std::vector<MapRequest>> RequestsOf(const SurfaceRequest& request,
                                             const std::vector<const Surface*>& components) {
  const bool is_one = components.size() == 1;
  const StatusOr<MapRequest> all = request(is_one ? *components[0] : Joined(components));
  if (!all.ok()) return all.status();
  if (is_one) return std::vector<MapRequest>{*all};
  std::vector<MapRequest> requests;
  Index vertices = 0, edges = 0, faces = 0;
  for (const Surface* component : components) {
    requests.push_back(Share(*component, vertices, edges, faces).Of(*all));
    vertices += component->triangulation.num_vertices;
    edges += component->triangulation.num_edges();
    faces += component->triangulation.num_faces();
  }
  return requests;
}

}  // namespace cirque
