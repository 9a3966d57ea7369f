#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/intrinsic/triple_flip_complex.h"
#include "cirque/math/log_triangle.h"

namespace cirque {

/// A triangulated surface up to discrete conformal equivalence, while its edges are flipped:
/// logarithms of edge lengths l (Penner's coordinates), which scales u at the vertices turn into
///   l~_ij = e^((u_i + u_j) / 2) l_ij.
/// A flip changes l by Ptolemy's theorem,
///   l_kl = (l_ik l_jl + l_il l_jk) / l_ij,
/// whatever the scales are: it is a change of coordinates of the ideal hyperbolic polyhedral metric
/// that all scaled metrics have in common, and of the scaled metric where the four points lie on a
/// circle. (A. Bobenko, U. Pinkall, B. Springborn, "Discrete conformal maps and ideal hyperbolic
/// polyhedra", Geom. Topol. 19, 2015; B. Springborn, "Ideal hyperbolic polyhedra and discrete
/// uniformization", Discrete Comput. Geom. 64, 2020.) Lengths are logarithms throughout, since
/// those of one surface can differ by hundreds of orders of magnitude, and have three times the digits of a
/// double: the angles of a needle with sides 1, 1 and e are in the logarithms' digits below e.
class PtolemyComplex {
 public:
  /// `log_lengths`: E. `scaled_by`: V, scales that the lengths are multiplied with at once; empty: 0.
  PtolemyComplex(const Triangulation& triangulation, const Eigen::VectorXd& log_lengths,
                 const std::vector<TripleDouble>& scaled_by = {});

  Index num_faces() const { return complex_.num_halfedges() / 3; }
  Index num_halfedges() const { return complex_.num_halfedges(); }
  Index vertex(Index h) const { return complex_.vertex(h); }  ///< at the corner opposite h

  /// The logarithm of the scaled length of the edge of h; `scale`: u, V.
  double ScaledLogLength(Index h, const Eigen::VectorXd& scale) const;

  /// The face with scaled sides, side k that of halfedge 3 f + k.
  LogTriangle ScaledTriangle(Index face, const Eigen::VectorXd& scale) const;

  /// Flips edges until the scaled metric is Delaunay: across every interior edge
  ///   cos alpha_l + cos alpha_r >= 0,
  /// cosines by their law, which needs no triangle inequality; where all edges are so, every
  /// triangle has one. Ends always (Weeks' algorithm for the canonical decomposition of a decorated
  /// hyperbolic surface), unless more than 100 flips an edge are needed: then false, and the complex
  /// is somewhere on the way. Boundary edges stay; an edge with the same face on both sides is
  /// Delaunay. `scale`: u, V. `triangles`: then all faces as ScaledTriangle has them.
  bool MakeDelaunay(const Eigen::VectorXd& scale, std::vector<LogTriangle>* triangles = nullptr);

  /// Whether the edge of h is not Delaunay, by more than rounding (kPtolemyTolerance).
  bool ViolatesDelaunay(Index h, const Eigen::VectorXd& scale) const;

  /// Flips the edge of h. @pre two different faces are beside it.
  void Flip(Index h);

  /// Halfedges as they were handed to FlipComplex::Flip, in order.
  const std::vector<Index>& flips() const { return flips_; }

  /// The edge of the triangulation at construction that the edge of h still is; kNone: flipped.
  Index label(Index h) const { return complex_.label(h); }

  /// The complex as it stands, edges numbered afresh, and the logarithms of its edges.
  Triangulation MakeTriangulation(Index num_vertices) const;
  Eigen::VectorXd MakeLogLengths(const Triangulation& triangulation) const;
  std::vector<TripleDouble> MakeExtendedLogLengths(const Triangulation& triangulation) const;

 private:
  TripleDouble LogLength(Index h) const;
  TripleDouble ExtendedLogLength(Index h, const Eigen::VectorXd& scale) const;
  bool Violates(Index h, const LogTriangle& left, const LogTriangle& right,
                const Eigen::VectorXd& scale) const;
  bool ViolatesByCosines(Index h, const Eigen::VectorXd& scale) const;

  FlipComplex complex_;             ///< its lengths are logarithms
  std::vector<LowerDigits> lower_;  ///< of them, of halfedges
  std::vector<Index> flips_;
};

/// tan(alpha_l / 2) tan(alpha_r / 2) may exceed 1 by this much, relatively.
inline constexpr double kPtolemyTolerance = 1e-11;

}  // namespace cirque
