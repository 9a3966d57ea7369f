#include "cirque/layout/open_surface.h"

#include <cmath>
#include <utility>

namespace cirque {
namespace {

/// Walks over the faces, breadth first within each patch.
class DirectionWalk {
 public:
  DirectionWalk(const Triangulation& open, const CornerAngles& angles)
      : t_(open),
        angles_(angles),
        direction_(open.num_halfedges()),
        placed_(open.num_faces(), false) {}

  Eigen::VectorXd Walk() {
    for (Index f = 0; f < t_.num_faces(); ++f) {
      if (placed_[f]) continue;
      queue_.clear();
      Place(3 * f, 0);
      for (std::size_t head = 0; head < queue_.size(); ++head) PlaceNeighbours(queue_[head]);
    }
    return std::move(direction_);
  }

 private:
  void Place(Index h, double towards) {
    placed_[Triangulation::Face(h)] = true;
    queue_.push_back(Triangulation::Face(h));
    for (int k = 0; k < 3; ++k) {
      direction_[h] = towards;
      towards += kPi - angles_.value[Triangulation::Prev(h)];
      h = Triangulation::Next(h);
    }
  }

  void PlaceNeighbours(Index face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index g = t_.twin[h];
      if (g != kNone && !placed_[Triangulation::Face(g)]) {
        Place(g, std::remainder(direction_[h] + kPi, 2 * kPi));
      }
    }
  }

  const Triangulation& t_;
  const CornerAngles& angles_;
  Eigen::VectorXd direction_;
  std::vector<bool> placed_;
  std::vector<Index> queue_;
};

}  // namespace

Eigen::Vector2d OpenSurface::Wanted(Index h) const {
  return lengths.value[triangulation.edge[h]] *
         Eigen::Vector2d(std::cos(direction[h]), std::sin(direction[h]));
}

EdgeLengths OpenedLengths(const Triangulation& t, const EdgeLengths& lengths,
                          const Triangulation& open) {
  EdgeLengths opened{Eigen::VectorXd(open.num_edges())};
  for (Index e = 0; e < open.num_edges(); ++e) {
    opened.value[e] = lengths.value[t.edge[open.edge_halfedge[e]]];
  }
  return opened;
}

OpenSurface OpenWithDirections(const Triangulation& t, const CornerAngles& flat_angles,
                               const EdgeLengths& lengths, const Cut& cut) {
  OpenSurface open;
  open.triangulation = CutOpen(t, cut);
  open.patches = ConnectedPatches(open.triangulation);
  open.direction = DirectionWalk(open.triangulation, flat_angles).Walk();
  open.lengths = OpenedLengths(t, lengths, open.triangulation);
  return open;
}

}  // namespace cirque
