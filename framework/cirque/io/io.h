#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/atomic_file.h"
#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Reads a mesh by its file name's extension (any case):
///
///   obj   Wavefront OBJ, with texture coordinates    read and written
///   off   text OFF                                   read and written
///   ply   PLY, text or binary, texture coordinates   read; written (text, without them)
///   stl   STL, text or binary                        read
///
/// A new format is a function to parse or write it in a file of its own, declared in
/// mesh_formats.h, and a line in io.cc. Errors name file:line (binary files: the byte), what was
/// expected, and what to do. Nothing is repaired here, and coordinates that are not finite are read
/// as such: see preflight.h.
StatusOr<PolygonSoup> ReadMesh(const std::string& path);

/// What follows the last dot of the file's name, in lower case: the format of a mesh. Devices and
/// streams without one (/dev/stdin, /dev/stdout) hold an obj.
std::string MeshExtension(const std::string& path);

/// The same from the file's content; `path` gives the format and serves the messages.
StatusOr<PolygonSoup> ParseMesh(const std::string& path, std::string_view content);

/// The content of a file of that name, coordinates in shortest round-trip digits. Refused as below.
StatusOr<TextPieces> FormatMesh(const std::string& path, const PolygonSoup& mesh);

/// Writes a mesh by its file name's extension, atomically, coordinates in shortest round-trip
/// digits. Refuses coordinates that are not finite, and texture coordinates where the format is not
/// obj.
Status WriteMesh(const std::string& path, const PolygonSoup& mesh);

/// The extensions that ReadMesh and WriteMesh know, in the order of the table.
std::vector<std::string> ReadableExtensions();
std::vector<std::string> WritableExtensions();

}  // namespace cirque
