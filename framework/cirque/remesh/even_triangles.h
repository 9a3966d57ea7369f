#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/lattice/flat_domain.h"
#include "cirque/remesh/flat_mesh.h"

namespace cirque {

/// How long edges shall be in a flat domain: exp of what is linear on its faces.
class SizeField {
 public:
  /// `log_size` (V): at the vertices of the domain, which must outlive this.
  SizeField(const FlatDomain& domain, Eigen::VectorXd log_size)
      : domain_(domain), log_size_(std::move(log_size)) {}

  double At(const FlatPoint& point) const;

 private:
  const FlatDomain& domain_;
  Eigen::VectorXd log_size_;
};

/// Triangles of the lengths that a size field asks for: edges of more than 4/3 of that are split,
/// shorter ones than 4/5 collapsed, the others turned until they are Delaunay, and vertices moved to
/// the centroids of their triangles, all of it in the flat metric and `rounds` times. (The steps are
/// those of M. Botsch, L. Kobbelt, "A Remeshing Approach to Multiresolution Modeling", 2004; in a flat
/// metric they need no projection.) In the end no face has a vertex twice and no two vertices have
/// two edges; where the sizes are too large for that, edges stay shorter.
///
/// Error (kNotConverged): such edges remain, which rounding keeps from being split; (kCancelled).
Status MakeEvenTriangles(const SizeField& size, int rounds, const SolveControl& control,
                         FlatMesh* mesh);

/// The mean of the lengths of edges over what is wanted there (the geometric mean at their ends).
double MeanLengthRatio(const SizeField& size, const FlatMesh& mesh);

/// Turns edges until all are Delaunay to 1e-9 rad, but for those that would make a second edge
/// between two vertices.
void FlipToDelaunay(FlatMesh* mesh);

/// The loops and the second edges of a mesh, as halfedges.
std::vector<Index> EdgesAgainstSimplicity(const FlatMesh& mesh);

}  // namespace cirque
