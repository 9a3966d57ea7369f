#pragma once

#include <vector>

#include "cirque/io/polygon_soup.h"
#include "cirque/layout/exact_map.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// A mesh refined so that an exact map is linear on its triangles.
struct ExactMesh {
  /// Triangles with texture. The first points are those of the input, in its order; the others lie
  /// on edges of its triangles.
  PolygonSoup mesh;
  std::vector<Index> polygon;  ///< of the input: in which every triangle lies; not decreasing
  /// Of conformal equivalence: for each of mesh.texture the weight w of the projective interpolation
  /// between them, sum x_k w_k uv_k / sum x_k w_k, largest 1 in a component; empty: a circle pattern,
  /// whose map is linear. (Springborn, Schroeder, Pinkall 2008; ideal_geodesic.h.)
  std::vector<double> weight = {};
  /// Of a map to the unit sphere: where it has each of mesh.position, which then have no texture; 0
  /// where no triangle is.
  std::vector<Eigen::Vector3d> sphere = {};
};

/// The homogeneous texture coordinates (w u, w v, w), which rasterisers interpolate linearly and
/// divide by the last at each pixel. @pre weights.
std::vector<Eigen::Vector3d> HomogeneousTexture(const ExactMesh& exact);

/// The input refined by the exact map of `surface`, which was made of it; without the triangles of
/// a fill (FillHoles).
ExactMesh RefineByExactMap(const PolygonSoup& input, const Surface& surface, const ExactMap& map);

}  // namespace cirque
