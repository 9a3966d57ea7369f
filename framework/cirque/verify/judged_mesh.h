#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "cirque/io/polygon_soup.h"
#include "cirque/verify/mesh_match.h"
#include "cirque/verify/polygon_check.h"
#include "cirque/verify/topology.h"

namespace cirque::verify {

/// The images of the faces, exactly. Numbers of IN's faces, and none twice.
struct Orientations {
  std::vector<Index> flipped;    ///< turned over against IN's orientation
  std::vector<Index> zero_area;  ///< with all corners in a line
  std::vector<Index> folded;     ///< polygons whose border crosses or touches itself
  Index num_upright = 0;         ///< faces, and pieces of faces, that are none of these
};

/// What the image of a face, or of a piece, is, with triangles that fill it.
using ImageOf = std::function<std::pair<PolygonShape, std::vector<int>>(
    const std::vector<FaceCorner>& corners)>;

/// Whether two corners have the same image.
using SameImage = std::function<bool(const FaceCorner&, const FaceCorner&)>;

/// The mesh that is judged: IN's faces with IN's vertices, in IN's order and orientation, with the
/// corners that OUT has there.
struct JudgedMesh {
  TriangleMesh mesh;
  Orientations orientations;
};

/// How IN's faces are to be taken.
struct JudgedFaces {
  std::vector<bool> turned;  ///< run against their neighbours in IN
  std::vector<bool> left_out;
};

/// IN's orientation of a face, or the opposite one where it is turned, is the direction in which it
/// is judged, whatever OUT's is. Corners that repeat the vertex of the one before, with the same
/// image, count once.
JudgedMesh BuildJudgedMesh(const PolygonSoup& in, const JudgedFaces& faces, const MeshMatch& match,
                           const ImageOf& image_of, const SameImage& same);

/// Per face of IN whether it was turned to agree with its neighbours.
std::vector<bool> TurnedFaces(const PolygonSoup& in, const Surface& surface);

/// Those faces of IN that OUT has in pieces which lie partly outside of the face, in projection to
/// its mean plane, where its border is simple, and along the axis nearest to that plane's normal.
std::vector<Index> FoldedTriangulations(const PolygonSoup& in, const MeshMatch& match);

}  // namespace cirque::verify
