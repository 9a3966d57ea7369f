#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/layout/exact_map.h"

/// From one map of a surface to another one: points, values and textures.
namespace cirque {

/// A map as triangles, each with its image and where it lies on the surface: in one of its faces.
struct MappedTriangles {
  std::vector<Eigen::Vector2d> uv;       ///< 3T, positively oriented
  std::vector<Eigen::Vector3d> on_face;  ///< 3T: barycentric coordinates in the face
  std::vector<Index> face;               ///< T

  Index num_triangles() const { return static_cast<Index>(face.size()); }
};

/// The surface's own triangles.
MappedTriangles TrianglesOf(const Triangulation& triangulation, const CornerUv& uv);

/// Those of an exact map of it to the plane. @pre no face has a vertex twice.
MappedTriangles TrianglesOf(const Triangulation& triangulation, const ExactMap& map);

/// Finds points of a map: in the plane by a grid of about one triangle a cell, on the surface by
/// its faces. Expected O(1) a point where triangles are of like size.
class MapLocator {
 public:
  explicit MapLocator(MappedTriangles map);

  /// The point of the surface that is mapped to a point of the plane; nothing where none is. On an
  /// edge (to 1e-12 of a triangle) any of the triangles there, in a map that overlaps itself the
  /// one that has the point farthest inside.
  std::optional<SurfacePoint> PointAt(const Eigen::Vector2d& uv) const;

  /// The image of a point of the surface, of the triangle that has it farthest inside (a point on a
  /// seam has another image too).
  Eigen::Vector2d UvAt(const SurfacePoint& point) const;

  /// A triangle of the map and barycentric coordinates in it.
  struct Place {
    Index triangle = kNone;
    Eigen::Vector3d weight = Eigen::Vector3d::Zero();
  };
  /// The triangle that has a point of the surface farthest inside; kNone: none is in its face.
  Place Find(const SurfacePoint& point) const;

  const Eigen::AlignedBox2d& box() const;  ///< of the image

 private:
  struct Grid;
  std::shared_ptr<const Grid> grid_;
};

/// An image over a rectangle of the plane. Texel (i, j) has its centre at the rectangle's lower
/// left corner + ((i + 1/2) / width, (j + 1/2) / height) of its sides.
struct Texture {
  int width = 0, height = 0, channels = 1;
  Eigen::AlignedBox2d frame;
  std::vector<double> value;  ///< width x height x channels, rows from below

  Eigen::Vector2d Centre(int i, int j) const;
  const double* At(int i, int j) const { return &value[Offset(i, j)]; }
  double* At(int i, int j) { return &value[Offset(i, j)]; }
  /// Bilinear between the texels' centres, constant beyond the outermost.
  Eigen::VectorXd Sample(const Eigen::Vector2d& uv) const;

 private:
  std::size_t Offset(int i, int j) const {
    return (static_cast<std::size_t>(j) * width + i) * channels;
  }
};

/// What is painted on a surface: a value of as many channels at every point.
using SurfaceColour = std::function<Eigen::VectorXd(const SurfacePoint&)>;

/// Fills a texture whose size, channels and frame are set: texels of the map's image by what their
/// centre's point has, and `margin` texels around them by the mean of those beside that have a
/// value, ring by ring, so that sampling near seams finds none without. What is left is 0.
void BakeTexture(const MapLocator& map, const SurfaceColour& colour, int margin, Texture* texture);

/// The texture of one map moved to another map of the same surface: every texel of `to` takes what
/// its point has in `texture` where `from` has it.
void TransferTexture(const MapLocator& from, const Texture& texture, const MapLocator& to,
                     int margin, Texture* moved);

/// Values of the vertices (V rows) at points of the surface, linear on its faces.
Eigen::MatrixXd ValuesAt(const Triangulation& triangulation, const Eigen::MatrixXd& of_vertices,
                         const std::vector<SurfacePoint>& points);

}  // namespace cirque
