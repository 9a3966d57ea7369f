#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/verify/topology.h"

namespace cirque::verify {

/// Which triangle of OUT is which of IN. Numbers are the fan triangles of each file.
struct Correspondence {
  std::vector<Index> out_triangle;  ///< per triangle of IN; kNone where OUT lacks it
  std::vector<Index> missing;       ///< triangles of IN that OUT lacks
  std::vector<Index> extra;         ///< triangles of OUT that IN lacks
  std::vector<Index> reversed;      ///< triangles of IN that run the other way round in OUT
  bool same_order = false;          ///< OUT lists them as IN does

  bool complete() const { return missing.empty() && extra.empty(); }
};

/// Triangles correspond when they have the same three vertices, in any cyclic order or reversed.
Correspondence MatchTriangles(const FanMesh& in, const FanMesh& out);

/// The triangles of `out` in the order of IN's, by a complete correspondence.
FanMesh Reorder(const FanMesh& out, const Correspondence& correspondence);

/// How far OUT's vertices are from IN's, relative to the diagonal of IN's bounding box.
struct Displacement {
  double largest = 0;
  std::vector<Index> moved;  ///< the vertices displaced by more than the tolerance, or not finite
};
Displacement ComparePositions(const std::vector<Eigen::Vector3d>& in,
                              const std::vector<Eigen::Vector3d>& out, double tolerance);

}  // namespace cirque::verify
