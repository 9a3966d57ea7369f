#include "cirque/layout/move_vertices.h"

#include <algorithm>
#include <limits>

#include "cirque/layout/map_objective.h"
#include "cirque/layout/vertex_star.h"

namespace cirque {
namespace {

/// One move can mirror no face, so every sweep that moves anything leaves fewer of them.
bool IsMirrored(const FlatOnInput& flat, Index face) {
  const auto& angle = flat.angles.value;
  return !(angle[3 * face] > 0 && angle[3 * face + 1] > 0 && angle[3 * face + 2] > 0);
}

/// Moves the best of the face's vertices, if any can right the whole star around it.
bool RightFace(const Triangulation& t, const CornerAngles& surface_angles,
               const EdgeLengths& surface_lengths, const std::vector<bool>& movable, Index face,
               FlatOnInput* flat) {
  const MapObjective objective = *MapObjectives().Find("mips");
  Index best = kNone;
  std::complex<double> best_place;
  double least = std::numeric_limits<double>::infinity();
  for (Index corner = 3 * face; corner < 3 * face + 3; ++corner) {
    if (!movable[t.vertex[corner]]) continue;
    const VertexStar star(t, surface_angles, surface_lengths, *flat, corner);
    if (!star.IsSimple()) continue;
    const auto place = star.BestPlace(objective);
    if (!place || !(star.WorstDistortion(*place) < least)) continue;
    best = corner;
    best_place = *place;
    least = star.WorstDistortion(*place);
  }
  if (best == kNone) return false;
  VertexStar(t, surface_angles, surface_lengths, *flat, best).MoveTo(best_place, flat);
  return true;
}

}  // namespace

int RightMirroredFaces(const Triangulation& t, const CornerAngles& surface_angles,
                       const EdgeLengths& surface_lengths, const std::vector<bool>& movable,
                       FlatOnInput* flat) {
  int moves = 0;
  for (bool moved = true; moved && !flat->mirrored.empty();) {
    moved = false;
    std::vector<Index> left;
    for (const Index face : flat->mirrored) {
      if (!IsMirrored(*flat, face)) continue;
      if (RightFace(t, surface_angles, surface_lengths, movable, face, flat)) {
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
