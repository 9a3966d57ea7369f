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

/// Parses a cone file (L. Kharevych's thesis), text, '#' starts a comment, a line a cone:
///
///   vertex min max    the angle sum Theta_v lies in [min pi, max pi]
///   vertex angle      Theta_v = angle pi
///
/// Vertices are counted from 1 as in the OBJ file. Interior and boundary vertices that the file
/// does not name stay as in FreeBoundaryTargets.
///
/// Errors are "path:line: ...": no such vertex, a vertex of no face or named twice, min above max,
/// a negative or infinite angle, a vertex fixed to 0, an angle that the corners of the vertex
/// cannot reach (pi each).
StatusOr<ConeTargets> ParseConeFile(const std::string& path, std::string_view content,
                                    const Triangulation& triangulation,
                                    const FileVertices& vertices);

/// Parses a file of target angle sums: one number [rad] a line for every vertex of the mesh file,
/// in its order; that of an isolated vertex is ignored. Every sum is fixed, on the boundary too.
/// Errors as above, and fewer or more sums than vertices.
StatusOr<ConeTargets> ParseAngleSumFile(const std::string& path, std::string_view content,
                                        const Triangulation& triangulation,
                                        const FileVertices& vertices);

/// The same from files.
StatusOr<ConeTargets> ReadConeFile(const std::string& path, const Triangulation& triangulation,
                                   const FileVertices& vertices);
StatusOr<ConeTargets> ReadAngleSumFile(const std::string& path, const Triangulation& triangulation,
                                       const FileVertices& vertices);

}  // namespace cirque
