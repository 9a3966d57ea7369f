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

struct LatticeTexture;

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
/// Passed over with a warning: faces of fewer than three corners; texture coordinates that corners
/// name and that are not there (an index of 0 too); all of them where a `vt` line is empty.
///
/// Errors are "path:line: ..." and say what was expected: a coordinate that is no number, a corner
/// that is none, a vertex index of 0, before the first or beyond the last.
StatusOr<PolygonSoup> ParseObj(const std::string& path, std::string_view text);

/// The mesh as Wavefront OBJ: its v lines, its vt lines, then `f v` or `f v/vt`, all in the soup's
/// order.
TextPieces FormatObj(const PolygonSoup& mesh);

/// The same with a line `g face_N` before every polygon whose group is another than that of the one
/// before, N the group's number from 1. @pre a group for every polygon, or none at all.
TextPieces FormatObjInGroups(const PolygonSoup& mesh, const std::vector<Index>& group);

/// The same with homogeneous texture coordinates, `vt wu wv w`, as CEPS writes them. @pre one for
/// each of mesh.texture.
TextPieces FormatHomogeneousObj(const PolygonSoup& mesh,
                                const std::vector<Eigen::Vector3d>& texture,
                                const std::vector<Index>& group);

/// An OBJ file's `text` with the texture coordinates of `textured`, whose polygons are those that
/// ParseObj reads from it. Kept byte for byte: materials, groups, normals, colours, comments, order,
/// blanks, line ends, continued lines, negative indices. Old `vt` lines are left out and the new ones
/// stand where the first of them or the first face stood, whichever comes first; corners name theirs
/// (none where theirs is kNone). References to texture in other lines (`l`, `surf`, faces of fewer
/// than three corners) are left out: the map has no texture coordinates for them.
TextPieces RewriteObj(std::string_view text, const PolygonSoup& textured);

/// Parses OFF; '#' starts a comment.
///
///   OFF                  or COFF, NOFF, STOFF and their mixtures
///   V F [E]              numbers of vertices, faces and edges, also behind the keyword
///   x y z ...            V lines; behind them normals and colours, which are ignored, and with ST,
///                        last, the vertex's texture coordinates u v
///   n v_1 ... v_n ...    F lines: vertices counted from 0; colours behind are ignored
///
/// or, behind a line `OFF BINARY`, the same in big-endian numbers of 32 bits: three integers; reals,
/// with 3 for the normal, 4 for the colour and 2 for the texture where the keyword has them; for each
/// face integers, the number of its colour's reals, and those.
///
/// Passed over with a warning: a missing keyword, faces of fewer than three corners, what follows
/// behind the last face, texture coordinates that some vertices lack.
///
/// Errors are "path:line: ...", in binary "path: byte N after the header: ...": no keyword and no
/// counts, 4OFF and nOFF (points of other than three coordinates), a number that is missing or none,
/// a vertex that does not exist, fewer lines than the header promises.
StatusOr<PolygonSoup> ParseOff(const std::string& path, std::string_view text);

/// The mesh as text OFF; with texture as STOFF, vertices split at seams (SplitAtSeams).
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
///   element tristrips 1                         instead of faces: triangles of three indices in a
///   property list int int vertex_indices        row, every second one turned; -1 ends a strip
///   end_header
///
/// Types are char, uchar, short, ushort, int, uint, float and double, or int8, uint8, int16,
/// uint16, int32, uint32, float32 and float64; any will do for a coordinate or a corner. All other
/// elements and properties (colours, normals) are skipped, and texture coordinates of vertices where
/// faces list some.
///
/// Passed over with a warning: other lines in the header, faces of fewer than three corners, lines
/// behind the last element.
///
/// Errors are "path:line: ...", in a binary body "path: byte N after the header: ...": a header
/// that is none or announces no polygons, a number that is missing or none, a list of impossible
/// length, a vertex that does not exist, a file that ends early.
StatusOr<PolygonSoup> ParsePly(const std::string& path, std::string_view content);

/// The mesh as text PLY with double coordinates; texture as properties s and t of the vertices, split
/// at seams (SplitAtSeams): what Blender, MeshLab and libigl read, while lists of the corners' are
/// read by MeshLab alone. Lists are of uchar lengths, which all readers know, unless a polygon has
/// more than 255 corners.
TextPieces FormatPly(const PolygonSoup& mesh);

/// Red, green and blue, each from 0 to 255.
using Colour = std::array<int, 3>;

/// Triangles, three corners each, as text PLY with a colour for every face; the comments, one line
/// each, stand in the header.
std::string FormatColouredPly(const std::vector<Eigen::Vector3d>& position,
                              const std::vector<Index>& corner, const std::vector<Colour>& colour,
                              const std::vector<std::string>& comments = {});

/// Whether the bytes are as many as a binary STL file's count announces.
bool IsBinaryStl(std::string_view content);

/// Parses STL, text or binary, told apart by the length that a binary file announces:
///
///   80 bytes     anything
///   uint32       F; all numbers are little-endian
///   F times:     float32 normal[3], corner[3][3]; 2 bytes of attributes
///
/// and as text, in capitals or not, words on lines of their own or not, `end solid` for `endsolid`:
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
/// ignored, and with a warning what stands behind the announced triangles where it is shorter than
/// one or all 0.
///
/// Errors are "path:line: ..." in text, else "path: ...": a word or a coordinate that is missing or
/// another, a file that ends early, a binary file of another length than it announces.
StatusOr<PolygonSoup> ParseStl(const std::string& path, std::string_view content);

/// Parses OM, OpenMesh's own binary format, of versions 1 and 2: positions in floats or doubles,
/// polygons that are not deleted, in their order, each from the vertex that its halfedge points to.
/// Normals, colours, texture coordinates and properties are passed over. Every count is checked
/// against the bytes that are there before anything is made of it.
///
///   "OM" T|Q|P version   vertices, faces, edges (32 bits each, little-endian), then chunks:
///   16 bits              entity, type, dimension and size of numbers
///   numbers              as many as the entity's count and the dimension say; named properties: a
///                        name, since 2.2 the name of its type, a size in bytes
///
/// Errors are "path: byte N: ..."; a file that ends early is refused.
StatusOr<PolygonSoup> ParseOm(const std::string& path, std::string_view content);

/// Whether these bytes begin as ParseOm's do.
bool IsOm(std::string_view content);

/// The mesh as binary glTF 2.0 (GLB) that shows itself: one mesh of one material, its texture a
/// checkerboard of about 32 squares across the map (KHR_texture_transform scales it, TEXCOORD_0 are the
/// map's own). Coordinates are rounded to single precision, the largest rounding stands in the
/// mesh's `extras`; polygons are cut into triangles in the map's plane, vertices split at seams
/// (SplitAtSeams), v counted downwards as glTF has it. No normals: viewers then shade each triangle
/// by itself.
TextPieces FormatGlb(const PolygonSoup& mesh);

/// The same of a map in units of a lattice, whose seams take the lattice to itself: its texture is one period of
/// the lattice's pattern (PatternDistance), which repeats without a seam. TEXCOORD_0 are coordinates of the
/// lattice's periods, which the mesh's `extras` name as `texture_periods`: on a lattice of triangles they
/// are sheared, as pictures are squares. Cones are marked by small octahedra, orange of less than 2 pi and violet of more,
/// in nodes of their own that can be hidden, `extras` with their angle sums.
TextPieces FormatLatticeGlb(const PolygonSoup& mesh, const LatticeTexture& lattice);

/// Why FormatGlb cannot hold the mesh (numbers beyond single precision, more than 4 GiB); else empty.
std::string ProblemAsGlb(const PolygonSoup& mesh);

}  // namespace cirque
