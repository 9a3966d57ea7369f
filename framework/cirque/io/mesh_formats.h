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

/// Parses Wavefront OBJ: text, a statement a line, '#' starts a comment.
///
///   v x y z            a point; weights and colours after it are ignored
///   vt u [v]           a texture coordinate, v = 0 where it is left out
///   f c c c ...        a polygon of three corners or more, each of them one of
///                        v   v/vt   v//vn   v/vt/vn
///   (any other word)   ignored, normals among them
///
/// Indices count from 1, or backwards from the latest (-1) when negative; they may refer to later
/// lines. A backslash at the end of a line joins the next one to it.
///
/// Errors are "path:line: ..." and say what was expected: a coordinate that is no number, a corner
/// that is none, a face of fewer than three, an index of 0, before the first or beyond the last.
StatusOr<PolygonSoup> ParseObj(const std::string& path, std::string_view text);

/// The mesh as Wavefront OBJ: its v lines, its vt lines, then `f v` or `f v/vt`, all in the soup's
/// order.
TextPieces FormatObj(const PolygonSoup& mesh);

/// Parses text OFF; '#' starts a comment.
///
///   OFF                  or COFF, NOFF, STOFF and their mixtures
///   V F [E]              numbers of vertices, faces and edges, also behind the keyword
///   x y z ...            V lines; normals, colours and texture coordinates behind are ignored
///   n v_1 ... v_n ...    F lines: vertices counted from 0; colours behind are ignored
///
/// Errors are "path:line: ...": no keyword, a number that is missing or none, fewer than three
/// corners, a vertex that does not exist, fewer or more lines than the header promises.
StatusOr<PolygonSoup> ParseOff(const std::string& path, std::string_view text);

/// The mesh as text OFF, without texture coordinates.
TextPieces FormatOff(const PolygonSoup& mesh);

/// Parses PLY, text or binary of either byte order: a header in text, then the elements that it
/// announces, one after the other.
///
///   ply
///   format ascii 1.0                            or binary_little_endian, binary_big_endian
///   element vertex V
///   property double x                           likewise y and z
///   property double s                           likewise t: texture coordinates; or u, v, or
///                                               texture_u, texture_v, or texture_s, texture_t
///   element face F
///   property list uchar int vertex_indices      or vertex_index: corners, counted from 0
///   property list uchar float texcoord          texture coordinates u v of each corner
///   end_header
///
/// Types are char, uchar, short, ushort, int, uint, float and double, or int8, uint8, int16,
/// uint16, int32, uint32, float32 and float64; any will do for a coordinate or a corner. All other
/// elements and properties (colours, normals) are skipped, and texture coordinates of vertices where
/// faces list some.
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

/// Parses STL, text or binary, told apart by the length that a binary file announces:
///
///   80 bytes     anything
///   uint32       F; all numbers are little-endian
///   F times:     float32 normal[3], corner[3][3]; 2 bytes of attributes
///
/// and as text, a statement a line:
///
///   solid NAME
///     facet normal x y z
///       outer loop
///         vertex x y z          three times
///       endloop
///     endfacet
///   endsolid NAME
///
/// STL repeats every vertex in each of its triangles: vertices of equal coordinates become one,
/// numbered by their first appearance. Several solids become one mesh; normals and attributes are
/// ignored.
///
/// Errors are "path:line: ..." in text, else "path: ...": a word or a coordinate that is missing or
/// another, a file that ends early, a binary file of another length than it announces.
StatusOr<PolygonSoup> ParseStl(const std::string& path, std::string_view content);

}  // namespace cirque
