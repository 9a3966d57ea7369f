#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/io/polygon_soup.h"
#include "cirque/verify/correspondence.h"

namespace cirque::verify {

/// How far OUT's vertices are from IN's, relative to the diagonal of the bounding box of those
/// vertices of IN that have a face. No others are looked at.
struct Displacement {
  double largest = 0;
  std::vector<Index> moved;  ///< vertices of IN displaced by more than the tolerance, or not finite
};
Displacement ComparePositions(const PolygonSoup& in, const std::vector<Eigen::Vector3d>& out,
                              double tolerance);

/// Which of OUT's faces are IN's, and by what that was found.
struct MeshMatch {
  NamedFaces in, out;
  Correspondence faces;
  Displacement displacement;
  bool by_position = false;  ///< and not by the vertices' numbers
  double scale = 1;          ///< OUT = scale IN + shift
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
};

/// By the numbers of the vertices, wherever they are. @pre both meshes have as many.
MeshMatch MatchByNumber(const PolygonSoup& in, const PolygonSoup& out);

/// By the numbers of the vertices, where no vertex is displaced by more than the tolerance and all
/// faces are found so; else by positions alone, since other programs split vertices at seams and
/// number them anew; else the same with OUT brought to IN's bounding box, since they scale and
/// shift meshes too. Where nothing matches everything: by the numbers, if there are as many, else by
/// positions.
MeshMatch MatchMeshes(const PolygonSoup& in, const PolygonSoup& out, double tolerance);

/// What is wrong with a match: vertices moved, faces missing and extra.
std::vector<std::string> MatchErrors(const PolygonSoup& in, const PolygonSoup& out,
                                     const MeshMatch& match, double tolerance);

}  // namespace cirque::verify
