#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

class TextWriter;

/// What a mesh file says, before anything is judged: P polygons with C corners in all on V numbered
/// points, in the file's order. A triangle and a quadrilateral on four points:
///
///   position        (0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)
///   first_corner    0, 3, 7
///   corner          0, 1, 2,  0, 1, 3, 2
struct PolygonSoup {
  std::vector<Eigen::Vector3d> position;  ///< V
  /// P + 1: polygon p owns corners [first_corner[p], first_corner[p + 1]).
  std::vector<Index> first_corner = {0};
  std::vector<Index> corner;             ///< C: the vertex of each polygon corner, from 0
  std::vector<Eigen::Vector2d> texture;  ///< texture coordinates; empty: the file has none
  /// C: per corner its texture coordinate or kNone; empty without texture.
  std::vector<Index> corner_texture;
  /// Where the first vertex that is not finite stands, "path:line" or the like; else empty.
  std::string not_finite_at;
  /// What the reader passed over, a sentence each that begins with its place: "path:line: ...".
  std::vector<std::string> warnings;

  Index num_polygons() const { return static_cast<Index>(first_corner.size()) - 1; }
};

/// For the formats: counts what a reader passes over, for one warning of all of its kind.
class PassedOver {
 public:
  explicit PassedOver(const char* what) : what_(what) {}

  /// It happened where `reader` (with a Place()) is now.
  template <class Reader>
  void At(const Reader& reader) {
    if (count_++ == 0) first_ = reader.Place();
  }

  /// "PLACE: WHAT", and how often more; nothing where it never happened.
  void Warn(PolygonSoup* soup) const;

 private:
  const char* what_;
  long long count_ = 0;
  std::string first_;
};

/// Faces of fewer than three corners, which some programs write for edges and points.
inline constexpr char kTooFewCorners[] = "a face of fewer than 3 corners is ignored";

/// For the formats: adds the polygon with these corners, counted from 0, to a soup that has all of
/// its vertices. Returns what is wrong with it, empty when nothing is; the polygon is then part of
/// the soup.
std::string AddPolygon(const std::vector<std::int64_t>& corners, PolygonSoup* soup);

/// For every point the first one with equal coordinates (0 equals -0; a point that is not finite
/// equals none): itself where there is none before it. Expected O(points).
std::vector<Index> FirstOfEqualPoints(const std::vector<Eigen::Vector3d>& points);

/// For formats that hold one texture coordinate a vertex: vertices of their own where a seam gives
/// one several. First come the mesh's vertices with the texture coordinates that their first
/// textured corners have, then the copies, in the order of the corners that need them. Texture
/// coordinates of equal bits are one.
struct SplitVertices {
  std::vector<Index> vertex;   ///< the vertex of the mesh that each is
  std::vector<Index> texture;  ///< its texture coordinate; kNone: no corner has any
  std::vector<Index> corner;   ///< C: which of them each corner is
};

/// @pre the mesh has texture.
SplitVertices SplitAtSeams(const PolygonSoup& mesh);

/// For the formats: the body that OFF and PLY share,
///
///   x y z [u v]      a line a vertex, in the fewest digits that read back to the same bits
///   n v_1 ... v_n    P lines: the number of corners and their vertices, counted from 0
///
/// with texture where `split` is given (u = v = 0 at vertices that have none).
void WritePointsAndPolygons(const PolygonSoup& mesh, const SplitVertices* split, TextWriter* out);

}  // namespace cirque
