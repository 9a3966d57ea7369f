#include "experiments/common/map_view/map_payload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "cirque/io/png.h"
#include "cirque/math/lattice_pattern.h"
#include "cirque/metrics/distortion_measure.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/metrics/measure_files.h"

namespace cirque {
namespace {

constexpr double kSteps = 65535;

/// Folds the sign of a difference into its lowest bit.
template <class Signed>
std::uint32_t Fold(Signed difference) {
  const auto wide = static_cast<std::int64_t>(difference);
  return static_cast<std::uint32_t>(wide >= 0 ? 2 * wide : -2 * wide - 1);
}

/// Of each value from the one before it, the first from 0.
template <class Unsigned>
std::vector<std::uint32_t> FoldedDifferences(const std::vector<Unsigned>& values) {
  std::vector<std::uint32_t> codes;
  Unsigned before = 0;
  for (const Unsigned value : values) {
    codes.push_back(Fold(static_cast<std::make_signed_t<Unsigned>>(value - before)));
    before = value;
  }
  return codes;
}

}  // namespace

void ByteStream::AddShorts(const std::vector<std::uint16_t>& values) {
  AddPlanes(FoldedDifferences(values), 2);
}

void ByteStream::AddWords(const std::vector<std::uint32_t>& values) {
  AddPlanes(FoldedDifferences(values), 4);
}

void ByteStream::AddPlanes(const std::vector<std::uint32_t>& codes, int planes) {
  for (int plane = 0; plane < planes; ++plane) {
    for (const std::uint32_t code : codes) {
      bytes_.push_back(static_cast<char>(code >> (8 * plane) & 0xff));
    }
  }
}

std::vector<std::uint16_t> Quantize(const std::vector<double>& values, double low, double high) {
  const double scale = high > low ? kSteps / (high - low) : 0;
  std::vector<std::uint16_t> steps;
  for (const double value : values) {
    const double step = std::isnan(value) ? 0 : std::clamp((value - low) * scale, 0.0, kSteps);
    steps.push_back(static_cast<std::uint16_t>(std::lround(step)));
  }
  return steps;
}

std::string Base64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

namespace {

constexpr int kScaleColours = 64;
const std::array<std::string, 2> kShownMeasures = {"quasi_conformal", "log_area_ratio"};

/// One coordinate of every place, and its range.
template <class Places>
std::vector<double> Coordinate(const Places& places, int k) {
  std::vector<double> values;
  for (const auto& place : places) values.push_back(place[k]);
  return values;
}

std::array<double, 2> Range(const std::vector<double>& values) {
  if (values.empty()) return {0, 0};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

/// The vertices in the order in which the points name them first, and the number of each in it.
struct VertexOrder {
  std::vector<Index> vertices, number;
};

VertexOrder OrderVertices(const UvMap& map) {
  VertexOrder order;
  order.number.assign(map.surface.triangulation.num_vertices, kNone);
  for (const Index vertex : map.point_vertex) {
    if (order.number[vertex] != kNone) continue;
    order.number[vertex] = static_cast<Index>(order.vertices.size());
    order.vertices.push_back(vertex);
  }
  return order;
}

void AddCoordinates(const std::vector<double>& values, ByteStream* stream, nlohmann::json* boxes) {
  const std::array<double, 2> range = Range(values);
  boxes->push_back(range);
  stream->AddShorts(Quantize(values, range[0], range[1]));
}

void AddIndices(const std::vector<Index>& indices, ByteStream* stream) {
  stream->AddWords(std::vector<std::uint32_t>(indices.begin(), indices.end()));
}

/// The face values of a metric, of degenerate faces the low end of the scale.
void AddColours(const MappedFaces& faces, const std::string& name, ByteStream* stream) {
  const DistortionMeasure metric = *DistortionMeasures().Find(name);
  const Eigen::VectorXd measured = metric.measure(faces).face_values;
  std::vector<double> values(faces.triangulation.num_faces(), metric.least);
  for (Index i = 0; i < faces.num_faces(); ++i) values[faces.face[i]] = measured[i];
  stream->AddShorts(Quantize(values, metric.least, metric.greatest));
}

std::string CssColour(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

/// What the viewer draws a lattice by: a period of its pattern as distances, so that edges are sharp at any
/// zoom, and the way from the plane into periods, columns first.
nlohmann::json LatticePayload(LatticeKind kind) {
  constexpr int kSide = 128;
  constexpr double kSlope = 1.5;  // distances of up to a third of a cell
  const Eigen::Vector2d x = InPeriods(kind, {1, 0}), y = InPeriods(kind, {0, 1});
  const std::vector<std::uint8_t> tile = PatternTile(kind, kSide, kSlope);
  return {{"order", OrderOf(kind)},
          {"to_periods", {x.x(), x.y(), y.x(), y.y()}},
          {"side", kSide},
          {"slope", kSlope},
          {"tile", Base64(Deflate({tile.begin(), tile.end()}))}};
}

}  // namespace

nlohmann::json MapPayload(const UvMap& map) {
  const Triangulation& mesh = map.surface.triangulation;
  const VertexOrder order = OrderVertices(map);
  std::vector<Eigen::Vector3d> position;
  for (const Index vertex : order.vertices) position.push_back(map.surface.position[vertex]);
  ByteStream stream;
  nlohmann::json boxes = nlohmann::json::array();
  for (int k = 0; k < 3; ++k) AddCoordinates(Coordinate(position, k), &stream, &boxes);
  for (int k = 0; k < (map.IsOnSphere() ? 3 : 2); ++k) {
    AddCoordinates(map.IsOnSphere() ? Coordinate(map.on_sphere, k) : Coordinate(map.point_uv, k),
                   &stream, &boxes);
  }
  const EdgeLengths lengths = MeasureEdgeLengths(map.surface);
  const MappedFaces faces = MeasureFaces(mesh, lengths, map.uv);
  for (const std::string& metric : kShownMeasures) AddColours(faces, metric, &stream);
  std::vector<Index> point_vertex;
  for (const Index vertex : map.point_vertex) point_vertex.push_back(order.number[vertex]);
  for (const auto& list : {point_vertex, map.point, map.seams, map.boundary}) {
    AddIndices(list, &stream);
  }
  nlohmann::json cones = nlohmann::json::array();
  for (const auto& [vertex, sum] : map.cones) cones.push_back({order.number[vertex], sum});
  nlohmann::json payload = {{"faces", mesh.num_faces()},
                            {"vertices", mesh.num_vertices},
                            {"points", map.point_vertex.size()},
                            {"sphere", map.IsOnSphere()},
                            {"seams", map.seams.size()},
                            {"boundary", map.boundary.size()},
                            {"boxes", boxes},
                            {"cones", cones},
                            {"data", Base64(Deflate(stream.bytes()))}};
  if (map.lattice) payload["lattice"] = LatticePayload(*map.lattice);
  return payload;
}

nlohmann::json ColourScales() {
  nlohmann::json scales = nlohmann::json::array();
  for (const std::string& name : kShownMeasures) {
    const DistortionMeasure metric = *DistortionMeasures().Find(name);
    nlohmann::json colours = nlohmann::json::array();
    for (int i = 0; i < kScaleColours; ++i) {
      const double t = static_cast<double>(i) / (kScaleColours - 1);
      const double value = metric.least + t * (metric.greatest - metric.least);
      colours.push_back(CssColour(ColourOnScale(value, metric.least, metric.greatest)));
    }
    scales.push_back({{"name", name},
                      {"meaning", metric.face_meaning},
                      {"least", metric.least},
                      {"greatest", metric.greatest},
                      {"colours", colours}});
  }
  return scales;
}

}  // namespace cirque
