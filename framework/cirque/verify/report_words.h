#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cirque/core/count.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/verify/uv_complex.h"

namespace cirque::verify {

/// What the faces of a mesh are called: "triangle", or "face" where some have more corners.
std::string FaceNoun(const PolygonSoup& soup);

/// "edge (3, 4) of face 7".
std::string NameEdge(const UvComplex& complex, Index halfedge);

/// A line of a report for people: a name, and in a column what is to be said of it.
std::string Line(const std::string& name, const std::string& text);

/// The JSON text of a report, without those members that are numbers but not finite.
std::string FiniteJson(nlohmann::ordered_json json);

}  // namespace cirque::verify
