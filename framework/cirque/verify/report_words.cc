#include "cirque/verify/report_words.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cirque::verify {

std::string FaceNoun(const PolygonSoup& soup) {
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    if (soup.first_corner[p + 1] - soup.first_corner[p] != 3) return "face";
  }
  return "triangle";
}

std::string NameEdge(const UvComplex& complex, Index halfedge) {
  const TriangleMesh& mesh = complex.mesh();
  return fmt::format("edge ({}, {}) of face {}", mesh.Origin(mesh.Tail(halfedge)),
                     mesh.Origin(mesh.Tip(halfedge)), complex.FaceOf(halfedge));
}

std::string Line(const std::string& name, const std::string& text) {
  return fmt::format("{:<18}{}\n", name, text);
}

namespace {

void DropUnknown(nlohmann::ordered_json* json) {
  if (!json->is_structured()) return;
  for (auto it = json->begin(); it != json->end();) {
    const bool drop =
        json->is_object() && it->is_number_float() && !std::isfinite(it->get<double>());
    if (drop) {
      it = json->erase(it);
    } else {
      DropUnknown(&*it++);
    }
  }
}

}  // namespace

std::string FiniteJson(nlohmann::ordered_json json) {
  DropUnknown(&json);
  return json.dump(2) + "\n";
}

}  // namespace cirque::verify
