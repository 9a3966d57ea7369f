#include "cirque/domains/pins.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/option.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/file_input.h"
#include "cirque/layout/landmarks.h"
#include "cirque/layout/seams.h"
#include "cirque/layout/stretch_energy.h"
#include "cirque/math/moebius.h"
#include "cirque/math/similarity.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

constexpr std::size_t kOfSimilarity = 2;  ///< pins
constexpr double kCollapses = 0.1;        ///< of the pins' spread: a similarity is mirrored

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

/// The one that comes nearest in the mean square; of two pins exactly. Of pins that are mirrored in the map
/// it would be a point: then only the place and the size.
StatusOr<Similarity> SimilarityOf(const Surface& surface, const std::vector<Pin>& pins,
                                  const CornerUv& uv) {
  std::vector<Complex> from, to;
  for (const Pin& pin : pins) {
    const StatusOr<Complex> place = PlaceOf(surface, uv, pin.vertex);
    if (!place.ok()) return place.status();
    from.push_back(*place);
    to.emplace_back(pin.at.x(), pin.at.y());
  }
  if (pins.size() == 1) return Similarity{1, from[0], to[0]};
  std::optional<Similarity> similarity = NearestSimilarity(from, to);
  if (!similarity) {
    return Status::InvalidInput(
        "pins: the map has all these vertices at one place; pin other ones");
  }
  double spread = 0, wanted = 0;
  for (std::size_t k = 0; k < pins.size(); ++k) {
    spread += std::norm(from[k] - similarity->from);
    wanted += std::norm(to[k] - similarity->to);
  }
  const double size = std::sqrt(wanted / spread);
  if (std::abs(similarity->factor) < kCollapses * size) similarity->factor = size;
  return *similarity;
}

Status CheckFlips(const Surface& surface, SurfaceMap* map) {
  const std::vector<Index> flipped = FlippedFaces(surface.triangulation, map->uv);
  Fill(&map->certificate.layout).flipped_triangles = static_cast<int>(flipped.size());
  if (flipped.empty()) return Status();
  return Status(StatusCode::kUnrepresentable,
                fmt::format("pins: doubles cannot hold faces {} (0-based) of the map there",
                            IdList(flipped, 5)));
}

/// What the map is bent by.
StatusOr<StretchEnergy> EnergyOf(const std::string& refine_map, RefineStretchOptions* options) {
  if (!LeavesConformal(refine_map)) {
    options->weight = 0;
    return StretchEnergies().Find("area");
  }
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(refine_map);
  if (!named.ok()) return named.status();
  StatusOr<StretchEnergy> energy = StretchEnergies().Find(named->name);
  const Status status = RefineStretchOptionTable(energy->blends).Set(named->options, options);
  if (!status.ok()) return status;
  return energy;
}

/// The pin farthest from its place, and how far.
std::pair<Pin, double> FarthestPin(const Surface& surface, const std::vector<Pin>& pins,
                                   const CornerUv& uv) {
  std::pair<Pin, double> farthest{pins[0], -1};
  for (const Pin& pin : pins) {
    const StatusOr<Complex> place = PlaceOf(surface, uv, pin.vertex);
    const double miss = std::abs(*place - Complex(pin.at.x(), pin.at.y()));
    if (miss > farthest.second) farthest = {pin, miss};
  }
  return farthest;
}

/// Three pins or more, of a map without flips near them.
Status BendToPins(const Surface& surface, const MapRequest& request, const std::vector<Pin>& pins,
                  const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  RefineStretchOptions options;
  const StatusOr<StretchEnergy> energy = EnergyOf(request.options.refine_map, &options);
  if (!energy.ok()) return energy.status();
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(t, lengths);
  std::vector<Seam> seams;
  if (!map->cut.IsEmpty()) {
    if (map->flat.on_input.angles.value.size() == 0) {
      return Status::InvalidInput(
          "pins: three or more bend a map with seams, which needs the flat metric that this one "
          "was "
          "made without; leave out solve_at, or pin two vertices");
    }
    seams = MeasureSeams(t, map->cut, ConeVertices(intrinsic.boundary, map->targets),
                         map->flat.on_input.angles, map->uv)
                .seams;
  }
  std::vector<Landmark> landmarks;
  for (const Pin& pin : pins) landmarks.push_back({pin.vertex, pin.at});
  control.BeginStage("pins");
  const StatusOr<LandmarkFit> fit =
      MeetLandmarks({intrinsic, map->cut, seams}, *energy, options, landmarks,
                    request.shape.pin_weight, control.cancelled, &map->uv);
  if (!fit.ok()) return fit.status();
  map->certificate.pins = PinSummary{static_cast<int>(pins.size()),
                                     fit->steps,
                                     fit->miss_before,
                                     fit->miss_after,
                                     fit->energy_before,
                                     fit->energy_after};
  if (fit->exact) map->certificate.pins->miss_after = 0;
  if (fit->exact || request.shape.pin_weight > 0) return Status();
  const auto [pin, miss] = FarthestPin(surface, pins, map->uv);
  return Status(
      StatusCode::kNotConverged,
      fmt::format(
          "pins: the map could not be bent to all {} pins without flipping triangles; vertex "
          "{} stays {:.3g} away from its place. Pins that no map without flips can meet do "
          "this; move or leave out pins, or draw to them by pin_weight",
          pins.size(), surface.soup_vertex[pin.vertex] + 1, miss));
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

Status MoveToPins(const Surface& surface, const MapRequest& request, const std::vector<Pin>& pins,
                  const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const StatusOr<Similarity> similarity = SimilarityOf(surface, pins, map->uv);
  if (!similarity.ok()) return similarity.status();
  for (Eigen::Vector2d& p : map->uv.value) {
    const Complex z = (*similarity)(Complex(p.x(), p.y()));
    p = {z.real(), z.imag()};
  }
  const bool bends = pins.size() > kOfSimilarity;
  for (Index h = 0; h < t.num_halfedges() && !bends; ++h) {
    for (const Pin& pin : pins) {
      if (t.vertex[h] == pin.vertex) map->uv.value[h] = pin.at;
    }
  }
  Status status = CheckFlips(surface, map);
  if (status.ok() && bends) {
    status = BendToPins(surface, request, pins, control, map);
    if (status.ok()) status = CheckFlips(surface, map);
  }
  if (!status.ok()) return status;
  MeasureDistortion(t, MeasureEdgeLengths(surface), map->cut, map->uv, &map->certificate);
  return Status();
}

}  // namespace cirque
