#include "cirque/layout/move_vertices.h"

#include <complex>
#include <limits>
#include <optional>
#include <utility>

#include "cirque/layout/map_objective.h"
#include "cirque/layout/vertex_star.h"

namespace cirque {
namespace {

/// One move can mirror no face, so every sweep that moves anything leaves fewer of them.
bool IsFlipped(const InputChart& flat, Index face) {
  const auto& angle = flat.angles.value;
  return !(angle[3 * face] > 0 && angle[3 * face + 1] > 0 && angle[3 * face + 2] > 0);
}

/// Moves the best of the face's vertices, if any can right the whole star around it.
bool RightFace(const Triangulation& t, const CornerAngles& surface_angles,
               const EdgeLengths& surface_lengths, const std::vector<bool>& movable,
               const MapObjective& objective, Index face, InputChart* flat) {
  std::optional<VertexStar> best;
  std::complex<double> best_place;
  double least = std::numeric_limits<double>::infinity();
  for (Index corner = 3 * face; corner < 3 * face + 3; ++corner) {
    if (!movable[t.vertex[corner]]) continue;
    const VertexStar star(t, surface_angles, surface_lengths, *flat, corner);
    const auto place = star.IsSimple() ? star.BestPlace(objective) : std::nullopt;
    if (!place || !(star.WorstDistortion(*place) < least)) continue;
    best.emplace(star);
    best_place = *place;
    least = star.WorstDistortion(best_place);
  }
  if (best) best->MoveTo(best_place, flat);
  return best.has_value();
}

}  // namespace

int UntangleFlippedTriangles(const Triangulation& t, const CornerAngles& surface_angles,
                             const EdgeLengths& surface_lengths, const std::vector<bool>& movable,
                             InputChart* flat) {
  const MapObjective objective = *MapObjectives().Find("mips");
  int moves = 0;
  for (bool moved = true; moved && !flat->mirrored.empty();) {
    moved = false;
    std::vector<Index> left;
    for (const Index face : flat->mirrored) {
      if (!IsFlipped(*flat, face)) continue;
      if (RightFace(t, surface_angles, surface_lengths, movable, objective, face, flat)) {
        moved = true;
        ++moves;
      } else {
        left.push_back(face);
      }
    }
    flat->mirrored = std::move(left);
  }
  return moves;
}

}  // namespace cirque
