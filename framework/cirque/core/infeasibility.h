#pragma once

#include <vector>

#include "cirque/core/types.h"

namespace cirque {

/// A certificate of infeasibility (Farkas): multipliers y that leave no coherent angles. With all
/// angles in units of pi and s_v the angle sum of vertex v, every coherent system satisfies
///   sum_f y_f + sum_v y_v s_v = sum_e (A'y)_e . alpha_e,
/// so that none exists where
///   sum_f y_f + sum_v y_v (y_v > 0 ? lower_v : upper_v)  >  sum_e max over a in Q_e of (A'y)_e . a.
/// Here
///   (A'y)_e   y_f + y_v at the one or two corners opposite e: f the corner's face, v its vertex
///   Q_e       {a_l >= eps, a_r >= eps, a_l + a_r <= 1 - eps} for an interior edge,
///             [eps, 1 - eps] for a boundary edge.
/// All numbers are doubles and mean exactly what they say, so that the inequality can be checked
/// without rounding (HoldsExactly in angles/infeasibility.h).
struct InfeasibilityCertificate {
  double epsilon_over_pi = 0;
  std::vector<double> face_multiplier;    ///< F
  std::vector<Index> constrained_vertex;  ///< those with a prescribed angle sum, increasing
  std::vector<double> lower_over_pi;      ///< their angle sums' intervals
  std::vector<double> upper_over_pi;
  std::vector<double> vertex_multiplier;  ///< one per constrained vertex
  /// Where the multipliers are largest: look here first. In certificates the file's faces.
  std::vector<Index> carrying_faces;
  std::vector<Index> carrying_vertices;
  double margin = 0;  ///< left side minus right side, as computed
  /// kNone, or the vertex without whose faces the certificate is meant, the faces around it having
  /// the multiplier 0: of a closed surface (maps to the sphere), or on the boundary of a disk, of
  /// which the faces beyond chords are left out too (maps to the disk and half-plane).
  Index removed_vertex = kNone;

  /// Which triangles the faces are, where those of the file are polygons, or where it has others: F,
  /// the file's face, and 3F, the numbers of the corners among that face's corners, from 0. Empty:
  /// the file's faces are triangles, and these are all of them.
  std::vector<Index> triangle_face, triangle_corner;

  bool empty() const { return face_multiplier.empty(); }
};

}  // namespace cirque
