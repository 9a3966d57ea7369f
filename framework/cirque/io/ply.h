#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/atomic_file.h"
#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Parses PLY, text or binary of either byte order: a header in text, then the elements that it
/// announces, one after the other.
///
///   ply
///   format ascii 1.0                            or binary_little_endian, binary_big_endian
///   element vertex V
///   property double x                           likewise y and z
///   element face F
///   property list uchar int vertex_indices      or vertex_index: corners, counted from 0
///   end_header
///
/// Types are char, uchar, short, ushort, int, uint, float and double, or int8, uint8, int16,
/// uint16, int32, uint32, float32 and float64; any will do for a coordinate or a corner. All other
/// elements and properties (colours, normals, texture coordinates) are skipped.
///
/// Errors are "path:line: ...", in a binary body "path: byte N after the header: ...": a header
/// that is none or announces no polygons, a number that is missing or none, a list of impossible
/// length, a vertex that does not exist, a file that ends early or, in text, goes on.
StatusOr<PolygonSoup> ParsePly(const std::string& path, std::string_view content);

/// The mesh as text PLY with double coordinates, without texture coordinates. Lists are of uchar
/// lengths, which all readers know, unless a polygon has more than 255 corners.
TextPieces FormatPly(const PolygonSoup& mesh);

/// Red, green and blue, each from 0 to 255.
using Colour = std::array<int, 3>;

/// Triangles, three corners each, as text PLY with a colour for every face; the comments, one line
/// each, stand in the header.
std::string FormatColouredPly(const std::vector<Eigen::Vector3d>& position,
                              const std::vector<Index>& corner, const std::vector<Colour>& colour,
                              const std::vector<std::string>& comments = {});

}  // namespace cirque
