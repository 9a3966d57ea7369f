#pragma once

#include <map>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/cone_file.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {

class SparseCholesky;

/// The surface as its user has it, where that is not the connectivity cones are sought on. The
/// vertices are the same.
struct ConeSource {
  const IntrinsicSurface* surface = nullptr;
  FileVertices file;  ///< how a cone file numbers the vertices; empty: in order
};

/// An intrinsic metric in which cones are sought, with the linear model of what they do to it: the
/// metric e^{2u} g with cones of curvature mu is flat elsewhere where
///   L u = mu - K,
/// L the cotangent Laplacian (of half the sum of the two cotangents an edge; it should be one of
/// intrinsic Delaunay connectivity, where no weight is negative), K_v = 2 pi - Theta_v the
/// curvature of the metric, both V. This is the Yamabe equation, linear in the plane (M. Ben-Chen,
/// C. Gotsman, G. Bunin, "Conformal flattening by curvature prescription and metric scaling",
/// 2008), and half the logarithm of the area ratio is about u.
///
/// Closed surfaces: sum mu = 2 pi chi, u has mean 0. With a boundary u = 0 there, which makes the
/// area distortion least among all maps without cones (B. Springborn, P. Schroeder, U. Pinkall,
/// "Conformal equivalence of triangle meshes", 2008); the pipeline's free boundary, whose angles
/// the fit chooses, comes near that without being it.
class ConeProblem {
 public:
  /// All that is referred to must outlive the problem. An angle sum may count on the corners that
  /// its vertex has in both triangulations.
  explicit ConeProblem(IntrinsicSurface surface, ConeSource source = {});
  ConeProblem(const Triangulation& triangulation, const EdgeLengths& lengths)
      : ConeProblem(MeasureSurface(triangulation, lengths)) {}
  ConeProblem(const ConeProblem&) = delete;
  ConeProblem& operator=(const ConeProblem&) = delete;
  ~ConeProblem();

  const Triangulation& triangulation() const { return surface_.triangulation; }
  const EdgeLengths& lengths() const { return surface_.lengths; }
  const ConeSource& source() const { return source_; }  ///< complete

  bool IsClosed() const { return closed_; }
  double TotalCurvature() const { return total_curvature_; }  ///< 2 pi chi [rad]

  /// Vertices at which a cone may lie and u is unknown: those inside. In increasing order.
  const std::vector<Index>& candidates() const { return candidates_; }
  bool IsCandidate(Index v) const { return number_[v] != kNone; }

  const Eigen::VectorXd& curvature() const { return curvature_; }  ///< K [rad], 0 on the boundary
  const Eigen::VectorXd& area() const { return area_; }  ///< a third of the faces around, total 1

  /// The curvatures that a cone may have at v: an angle sum of at least pi/4, and of at most 0.6 pi
  /// a corner, with half a corner to spare: more bends the triangles around too much.
  double LeastCurvature(Index v) const;
  double GreatestCurvature() const { return 1.75 * kPi; }

  /// L u = b inside with u = 0 on the boundary; on a closed surface u has mean 0 and of b what its
  /// total is spread evenly over the area is taken away first. V both. The factor is made at the
  /// first call.
  Eigen::VectorXd Solve(const Eigen::VectorXd& b) const;

  /// u for no cones: of -K, made compatible as Solve does. Solved for once.
  const Eigen::VectorXd& LogScaleWithoutCones() const;

  /// What a unit of curvature at a vertex adds to u, V: Solve() of the unit vector, to rounding.
  using Response = std::shared_ptr<const Eigen::VectorXd>;

  /// Those of several candidates, solved for together. One heuristic begins where another has been,
  /// or asks again with more cones: those asked for first are kept, as many as take 32 MB.
  std::vector<Response> Responses(const std::vector<Index>& vertices) const;

  /// All of L at the candidates, numbered as `candidates()`.
  SparseMatrix Laplacian() const;

 private:
  SparseMatrix LowerLaplacian() const;
  void MakeFactor() const;
  Eigen::VectorXd AtVertices(const Eigen::VectorXd& solution, double total) const;
  std::vector<Response> SolveForUnits(const std::vector<Index>& vertices) const;

  IntrinsicSurface surface_;
  ConeSource source_;
  bool closed_;
  double total_curvature_;
  std::vector<Index> corners_, candidates_, number_;
  Eigen::VectorXd curvature_, area_;
  mutable std::unique_ptr<SparseCholesky> factor_;
  mutable Eigen::VectorXd of_area_;  ///< the factor's answer to the areas of the candidates
  mutable Eigen::VectorXd without_cones_;
  mutable std::map<Index, Response> kept_responses_;
};

/// sqrt(sum_v a_v u_v^2) with the areas of total 1.
double AreaNorm(const ConeProblem& problem, const Eigen::VectorXd& u);

}  // namespace cirque
