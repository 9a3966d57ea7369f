#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// How a file that speaks of vertices counts them.
struct FileVertices {
  Index count = 0;  ///< the mesh file's vertices, isolated ones too
  /// V: per vertex of the triangulation its number in the file, from 0 (Surface::soup_vertex).
  std::vector<Index> of_vertex;
};

/// Of a file that names the vertices in order, like a CON file.
FileVertices VerticesInOrder(Index count);

/// What the digits of a cone file left of Gauss-Bonnet, and what was done about it.
struct ConeFileRounding {
  /// [rad] by which the file's angle sums are above, or below (< 0), pi F; of several components the
  /// largest miss.
  double missed = 0;
  int cones = 0;       ///< whose angles were changed; 0: none had to be
  double largest = 0;  ///< [rad] change of an angle
};

/// Parses a cone file (L. Kharevych's thesis), text, '#' starts a comment, a line a cone:
///
///   vertex min max    the angle sum Theta_v lies in [min pi, max pi]
///   vertex angle      Theta_v = angle pi
///
/// Vertices are counted from 1 as in the OBJ file. Interior and boundary vertices that the file
/// does not name stay as in FreeBoundaryTargets.
///
/// Where all angle sums together miss what the triangles have (Gauss-Bonnet) by no more than the
/// digits of the file allow, half a unit of the last one for every angle, that is made good with the
/// least change of any angle, and `rounding` tells. An angle of less than three decimals (0.5, 1.25)
/// means what it says; zeros at the end count for nothing.
///
/// Errors are "path:line: ...": no such vertex, a vertex of no face or named twice, min above max,
/// a negative or infinite angle, a vertex fixed to 0, an angle that the corners of the vertex
/// cannot reach (pi each).
StatusOr<ConeTargets> ParseConeFile(const std::string& path, std::string_view content,
                                    const Triangulation& triangulation,
                                    const FileVertices& vertices,
                                    ConeFileRounding* rounding = nullptr);

/// Parses a file of target angle sums: one number [rad] a line for every vertex of the mesh file,
/// in its order; that of an isolated vertex is ignored. Every sum is fixed, on the boundary too.
/// Errors as above, and fewer or more sums than vertices.
StatusOr<ConeTargets> ParseAngleSumFile(const std::string& path, std::string_view content,
                                        const Triangulation& triangulation,
                                        const FileVertices& vertices);

/// The same from files.
StatusOr<ConeTargets> ReadConeFile(const std::string& path, const Triangulation& triangulation,
                                   const FileVertices& vertices,
                                   ConeFileRounding* rounding = nullptr);
StatusOr<ConeTargets> ReadAngleSumFile(const std::string& path, const Triangulation& triangulation,
                                       const FileVertices& vertices);

}  // namespace cirque
