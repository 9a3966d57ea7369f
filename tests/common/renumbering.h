#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A triangulation with its vertices, faces and corners numbered at random, and the way there: what
/// does not depend on numbering is the same on both.
struct Renumbering {
  Triangulation triangulation;
  std::vector<Index> vertex;    ///< the new number of every vertex
  std::vector<Index> halfedge;  ///< the new number of every halfedge

  EdgeLengths Lengths(const Triangulation& from, const EdgeLengths& lengths) const;
  ConeTargets Targets(const ConeTargets& targets) const;
  Eigen::VectorXd PerHalfedge(const Eigen::VectorXd& values) const;  ///< 3F, such as angles
};

Renumbering Renumber(const Triangulation& triangulation, unsigned seed);

}  // namespace cirque
