#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/triangulation.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// How good the triangles of a mesh are, and how near it is to another surface.
struct MeshQuality {
  Index vertices = 0, triangles = 0;
  double least_angle = 0;       ///< [degrees] of all triangles
  double mean_least_angle = 0;  ///< [degrees]: mean over triangles
  double largest_angle = 0;     ///< [degrees]
  double mean_edge = 0;
  double edge_deviation = 0;  ///< standard deviation of edges over their mean
  double edge_ratio = 0;      ///< longest edge over shortest
  double regular = 0;         ///< share of inner vertices with six edges
  /// Largest distance of points of the mesh (vertices, midpoints of edges, centroids) from the other
  /// surface, and the other way round; over the diagonal of the other's bounding box.
  double to_other = 0, from_other = 0;
};

/// What follows from the mesh alone.
MeshQuality MeasureQuality(const Triangulation& triangulation,
                           const std::vector<Eigen::Vector3d>& position);

/// Adds the distances.
void MeasureDistances(const Triangulation& triangulation,
                      const std::vector<Eigen::Vector3d>& position, const Surface& other,
                      MeshQuality* quality);

/// A line "name value" for each; and an object of JSON.
std::string ToText(const MeshQuality& quality);
std::string ToJson(const MeshQuality& quality);

/// The distance of points from triangles, by a tree of boxes. O(log F) a point, expected.
class TriangleTree {
 public:
  /// The corners of the triangles, three each; copied.
  explicit TriangleTree(std::vector<Eigen::Vector3d> corners);

  double Distance(const Eigen::Vector3d& point) const;

 private:
  struct Node {
    Eigen::Vector3d lower, upper;
    Index begin, end, right;  ///< of leaves: triangles; else the second child, the first is next
  };
  Index Build(Index begin, Index end);
  double SquaredDistanceToBox(Index node, const Eigen::Vector3d& point) const;
  double SquaredDistanceToTriangle(Index triangle, const Eigen::Vector3d& point) const;

  std::vector<Eigen::Vector3d> corner_;
  std::vector<Index> order_;
  std::vector<Node> node_;
};

}  // namespace cirque
