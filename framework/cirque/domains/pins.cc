#include "cirque/domains/pins.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/io/file_input.h"
#include "cirque/math/moebius.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

constexpr std::size_t kMostPins = 2;

class PinParser {
 public:
  PinParser(const std::string& path, std::string_view text, const Surface& surface)
      : scanner_(path, text) {
    for (std::size_t v = 0; v < surface.soup_vertex.size(); ++v) {
      vertex_.emplace(surface.soup_vertex[v] + 1LL, static_cast<Index>(v));
    }
  }

  StatusOr<std::vector<Pin>> Run() {
    while (scanner_.NextLine()) {
      if (Status s = ParseLine(); !s.ok()) return s;
    }
    if (pins_.empty()) return scanner_.Error("no pin; a line is 'vertex x y'");
    return std::move(pins_);
  }

 private:
  Status ParseLine() {
    const std::optional<long long> number = scanner_.Integer();
    if (!number) return scanner_.Expected("a vertex (counted from 1)");
    const std::optional<double> x = scanner_.Number();
    if (!x) return scanner_.Expected("where it goes, x and y");
    const std::optional<double> y = scanner_.Number();
    if (!y || !scanner_.AtLineEnd())
      return scanner_.Expected("where it goes, x and y, and no more");
    if (!std::isfinite(*x) || !std::isfinite(*y)) {
      return scanner_.Error("where a vertex goes must be finite");
    }
    const auto found = vertex_.find(*number);
    if (found == vertex_.end()) {
      return scanner_.Error(fmt::format("{} is no vertex of the surface", *number));
    }
    return Add({found->second, {*x, *y}});
  }

  Status Add(const Pin& pin) {
    for (const Pin& other : pins_) {
      if (other.vertex == pin.vertex) return scanner_.Error("the vertex has a pin already");
      if (other.at == pin.at) return scanner_.Error("another vertex is pinned there already");
    }
    if (pins_.size() == kMostPins) {
      return scanner_.Error(
          "a third pin; one pin moves the map and two turn and scale it, with more of them it "
          "could "
          "not keep its angles");
    }
    pins_.push_back(pin);
    return Status();
  }

  TextScanner scanner_;
  std::map<long long, Index> vertex_;
  std::vector<Pin> pins_;
};

/// Where the map has the vertex. Error: at several places.
StatusOr<Complex> PlaceOf(const Surface& surface, const CornerUv& uv, Index v) {
  const Triangulation& t = surface.triangulation;
  std::optional<Eigen::Vector2d> place;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.vertex[h] != v) continue;
    if (!place) place = uv.value[h];
    if (*place == uv.value[h]) continue;
    return Status::InvalidInput(fmt::format(
        "pins: vertex {} lies on the cut and has several places; pin another one, or lead the cut "
        "elsewhere",
        surface.soup_vertex[v] + 1));
  }
  return Complex(place->x(), place->y());
}

/// z -> factor (z - from) + to.
struct Similarity {
  Complex factor = 1, from, to;
};

StatusOr<Similarity> SimilarityOf(const Surface& surface, const std::vector<Pin>& pins,
                                  const CornerUv& uv) {
  std::vector<Complex> from, to;
  for (const Pin& pin : pins) {
    const StatusOr<Complex> place = PlaceOf(surface, uv, pin.vertex);
    if (!place.ok()) return place.status();
    from.push_back(*place);
    to.emplace_back(pin.at.x(), pin.at.y());
  }
  Similarity similarity{1, from[0], to[0]};
  if (pins.size() == 1) return similarity;
  if (from[0] == from[1]) {
    return Status::InvalidInput("pins: the map has both vertices at one place; pin other ones");
  }
  similarity.factor = (to[1] - to[0]) / (from[1] - from[0]);
  return similarity;
}

}  // namespace

StatusOr<std::vector<Pin>> ParsePins(const std::string& path, std::string_view text,
                                     const Surface& surface) {
  return PinParser(path, text, surface).Run();
}

StatusOr<std::vector<Pin>> ReadPins(const std::string& path, const Surface& surface) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status().In("pins");
  return ParsePins(path, *content, surface);
}

Status MoveToPins(const Surface& surface, const std::vector<Pin>& pins, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const StatusOr<Similarity> similarity = SimilarityOf(surface, pins, map->uv);
  if (!similarity.ok()) return similarity.status();
  for (Eigen::Vector2d& p : map->uv.value) {
    const Complex z =
        similarity->factor * (Complex(p.x(), p.y()) - similarity->from) + similarity->to;
    p = {z.real(), z.imag()};
  }
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    for (const Pin& pin : pins) {
      if (t.vertex[h] == pin.vertex) map->uv.value[h] = pin.at;
    }
  }
  const std::vector<Index> flipped = FlippedFaces(t, map->uv);
  Fill(&map->certificate.layout).flipped_triangles = static_cast<int>(flipped.size());
  if (!flipped.empty()) {
    return Status(StatusCode::kUnrepresentable,
                  fmt::format("pins: doubles cannot hold faces {} (0-based) of the map there",
                              IdList(flipped, 5)));
  }
  MeasureDistortion(t, MeasureEdgeLengths(surface), map->cut, map->uv, &map->certificate);
  return Status();
}

}  // namespace cirque
