#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/atomic_file.h"
#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

struct LatticeTexture;

/// The formats of meshes, by the extension of a file's name (any case):
///
///   obj   Wavefront OBJ                   read and written     the whole file is kept, see
/// MeshFile
///   off   OFF, text or binary             read and written     text; texture by split vertices
///   ply   PLY, text or binary             read and written     text; texture by split vertices
///   stl   STL, text or binary             read
///   om    OpenMesh's own, binary          read                 positions and polygons
///   glb   glTF 2.0                        written              binary, in single precision; shows
///                                                              itself with a checkerboard, or a
///                                                              lattice: WriteLatticeGlb
///
/// Files may be packed by gzip (`NAME.obj.gz`, or any name) and in UTF-16. Where the name tells no
/// format, or the content is plainly of another, the content decides (with a warning in the latter
/// case). "-" is the standard input.
///
/// A new format is a function to parse or write it in a file of its own, declared in
/// mesh_formats.h, and a line in io.cc. Errors name file:line (binary files: the byte), what was
/// expected, and what to do. Nothing is repaired here, and coordinates that are not finite are read
/// as such: see preflight.h. What is passed over stands in PolygonSoup::warnings.
StatusOr<PolygonSoup> ReadMesh(const std::string& path);

/// A mesh and what it takes to write its file again with other texture coordinates.
struct MeshFile {
  PolygonSoup soup;
  std::string text;  ///< of an obj; else empty
};

/// ReadMesh for whoever writes the file again.
StatusOr<MeshFile> ReadMeshFile(const std::string& path);

/// What follows the last dot of the file's name, in lower case: the format of a mesh. Devices and
/// streams without one (/dev/stdin, /dev/stdout) hold an obj.
std::string MeshExtension(const std::string& path);

/// The same from the file's content, as it is when unpacked; `path` gives the format and serves the
/// messages.
StatusOr<PolygonSoup> ParseMesh(const std::string& path, std::string_view content);

/// The content of a file of that name, coordinates in shortest round-trip digits. Refused as below.
StatusOr<TextPieces> FormatMesh(const std::string& path, const PolygonSoup& mesh);

/// Writes a mesh by its file name's extension, atomically, coordinates in shortest round-trip
/// digits. Refuses coordinates that are not finite or that the format cannot hold.
Status WriteMesh(const std::string& path, const PolygonSoup& mesh);

/// WriteMesh, where an .obj says of which face of another mesh each polygon is a part, by lines
/// `g face_N` with N from 1; `group`, from 0, for every polygon. Other formats have no groups.
Status WriteMeshInGroups(const std::string& path, const PolygonSoup& mesh,
                         const std::vector<Index>& group);

/// WriteMeshInGroups to an .obj with texture coordinates of three numbers instead of the mesh's own, one
/// for each of them: homogeneous (FormatHomogeneousObj), or points of space.
Status WriteHomogeneousObj(const std::string& path, const PolygonSoup& mesh,
                           const std::vector<Eigen::Vector3d>& texture,
                           const std::vector<Index>& group);

/// Writes the mesh of `source` with the texture coordinates of `textured`: an .obj from an obj is
/// the file as it was but for its `vt` lines and the indices of its corners (see RewriteObj in
/// mesh_formats.h), where `textured` has the polygons of `source`; anything else is `textured` by
/// WriteMesh.
Status WriteTexturedMesh(const std::string& path, const MeshFile& source,
                         const PolygonSoup& textured);

/// WriteMesh to a .glb of a map in units of a lattice (io/lattice_texture.h), which shows the lattice's
/// pattern, without seams, instead of a checkerboard.
Status WriteLatticeGlb(const std::string& path, const PolygonSoup& mesh,
                       const LatticeTexture& lattice);

/// The extensions that ReadMesh knows, those that WriteMesh writes exactly, and all that it
/// writes, in the order of the table.
std::vector<std::string> ReadableExtensions();
std::vector<std::string> WritableExtensions();
std::vector<std::string> MapExtensions();

}  // namespace cirque
