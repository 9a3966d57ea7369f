#pragma once

#include <vector>

#include "cirque/core/types.h"

namespace cirque {

/// A proof (Farkas) that no coherent angle system exists. Every one would satisfy, for any
/// multipliers y,
///   sum_f y_f + sum_v y_v s_v = sum_e (A'y)_e . alpha_e,
/// with s_v the angle sum of vertex v and all angles in units of pi; so multipliers with
///   sum_f y_f + sum_v y_v (y_v > 0 ? lower_v : upper_v)  >  sum_e max over Q_e of (A'y)_e . a
/// leave none. Q_e = {a_l >= eps, a_r >= eps, a_l + a_r <= 1 - eps} for an interior edge, [eps, 1 -
/// eps] for a boundary edge; (A'y)_e = (y_f + y_v) at the one or two corners opposite e, v the
/// vertex at the corner. All numbers are doubles and mean exactly what they say, so that the
/// inequality can be checked without rounding.
struct InfeasibilityCertificate {
  double epsilon_over_pi = 0;
  std::vector<double> face_multiplier;  ///< F
  std::vector<Index>
      constrained_vertex;             ///< the vertices whose angle sum is prescribed, increasing
  std::vector<double> lower_over_pi;  ///< their angle sums' intervals
  std::vector<double> upper_over_pi;
  std::vector<double> vertex_multiplier;  ///< one per constrained vertex
  std::vector<Index> carrying_faces;      ///< where the multipliers are largest: look here first
  std::vector<Index> carrying_vertices;
  double margin = 0;  ///< left side minus right side, as computed
  /// kNone, or the vertex without whose faces the proof is meant, the faces around it having the
  /// multiplier 0: of a closed surface (maps to the sphere), or on the boundary of a disk, of which
  /// the faces beyond chords are left out too (maps to the disk and half-plane).
  Index removed_vertex = kNone;

  bool empty() const { return face_multiplier.empty(); }
};

}  // namespace cirque
