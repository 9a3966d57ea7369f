#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/domains/transfer.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// The mesh that maps are of, as it is in its file and as surfaces, one behind the other.
struct MeshOfMaps {
  PolygonSoup soup;
  Surface surface;
};

StatusOr<MeshOfMaps> ReadSurface(const std::string& path);

/// A map of it: what circle_patterns writes as its output, or by --exact.
struct MapFile {
  PolygonSoup mesh;
  bool is_exact = false;
  MappedTriangles triangles;
  std::vector<Index> vertex;   ///< 3T: of every corner, in this file
  std::vector<Index> polygon;  ///< T: of every triangle, in this file
};

/// Errors (invalid input), each with the file's name: no texture coordinates; other faces or points
/// than the mesh has; of an exact map, a group of none of its faces.
StatusOr<MapFile> ReadMap(const std::string& path, const MeshOfMaps& of);

}  // namespace cirque
