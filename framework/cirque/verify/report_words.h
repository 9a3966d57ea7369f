#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cirque/io/polygon_soup.h"
#include "cirque/verify/uv_complex.h"

namespace cirque::verify {

/// "1 triangle", "3 triangles", "2 vertices", "2 patches".
std::string Count(std::size_t number, const std::string& singular);

/// What the faces of a mesh are called: "triangle", or "face" where some have more corners.
std::string FaceNoun(const PolygonSoup& soup);

/// "edge (3, 4) of face 7".
std::string NameEdge(const UvComplex& complex, Index halfedge);

/// A line of a report for people: a name, and in a column what is to be said of it.
std::string Line(const std::string& name, const std::string& text);

/// The JSON text of a report, without those members that are numbers but not finite.
std::string FiniteJson(nlohmann::ordered_json json);

}  // namespace cirque::verify
