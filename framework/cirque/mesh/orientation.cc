#include "cirque/mesh/orientation.h"

#include <algorithm>

#include "cirque/core/triangulation.h"

namespace cirque {
namespace {

/// Walks over one piece of the surface from `seed`, which stays as it is. Returns its triangles.
std::vector<Index> OrientPiece(const std::vector<Index>& triangles, const Gluing& gluing,
                               Index seed, std::vector<bool>* seen, Orientation* orientation) {
  std::vector<Index> piece = {seed};
  (*seen)[seed] = true;
  for (std::size_t next = 0; next < piece.size(); ++next) {
    const Index f = piece[next];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = gluing.mate[h];
      if (g == kNone) continue;
      const bool disagree = triangles[Triangulation::Next(h)] == triangles[Triangulation::Next(g)];
      const bool turn = orientation->turn[f] != disagree;
      const Index neighbour = Triangulation::Face(g);
      if (!(*seen)[neighbour]) {
        (*seen)[neighbour] = true;
        orientation->turn[neighbour] = turn;
        piece.push_back(neighbour);
      } else if (orientation->turn[neighbour] != turn && orientation->one_sided == kNone) {
        orientation->one_sided = h;
      }
    }
  }
  return piece;
}

}  // namespace

Orientation OrientTriangles(const std::vector<Index>& triangles, const Gluing& gluing) {
  const Index num_faces = static_cast<Index>(triangles.size() / 3);
  Orientation orientation;
  orientation.turn.assign(num_faces, false);
  std::vector<bool> seen(num_faces, false);
  for (Index seed = 0; seed < num_faces; ++seed) {
    if (seen[seed]) continue;
    const std::vector<Index> piece = OrientPiece(triangles, gluing, seed, &seen, &orientation);
    const auto turned =
        std::count_if(piece.begin(), piece.end(), [&](Index f) { return orientation.turn[f]; });
    if (2 * turned <= static_cast<std::ptrdiff_t>(piece.size())) continue;
    for (const Index f : piece) orientation.turn[f] = !orientation.turn[f];
  }
  return orientation;
}

void TurnTriangles(const std::vector<bool>& turn, std::vector<Index>* triangles,
                   std::vector<Index>* mate) {
  if (std::find(turn.begin(), turn.end(), true) == turn.end()) return;
  const auto moved = [&](Index h) {
    if (h == kNone || h % 3 == 0 || !turn[Triangulation::Face(h)]) return h;
    return h % 3 == 1 ? h + 1 : h - 1;
  };
  const std::vector<Index> old_triangles = *triangles, old_mate = *mate;
  for (Index h = 0; h < static_cast<Index>(old_mate.size()); ++h) {
    (*triangles)[moved(h)] = old_triangles[h];
    (*mate)[moved(h)] = moved(old_mate[h]);
  }
}

}  // namespace cirque
