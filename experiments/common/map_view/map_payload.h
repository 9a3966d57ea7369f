#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "experiments/common/map_view/uv_map.h"

namespace cirque {

/// Bytes in the order in which assets/mesh_payload.js reads them. A list of N values of 2 or 4
/// bytes is written as its differences d (modulo 2^16 or 2^32, from 0), each folded to
/// 2 d or -2 d - 1 so that small ones are small numbers, and these as N low bytes, then N next
/// bytes and so on: what neighbours in a mesh have in common then deflates well.
class ByteStream {
 public:
  void AddShorts(const std::vector<std::uint16_t>& values);
  void AddWords(const std::vector<std::uint32_t>& values);

  const std::string& bytes() const { return bytes_; }

 private:
  void AddPlanes(const std::vector<std::uint32_t>& codes, int planes);

  std::string bytes_;
};

/// The nearest of the 2^16 numbers from `low` (0) to `high` (65535) to each value;
/// what lies outside is clamped, NaN counts as low.
std::vector<std::uint16_t> Quantize(const std::vector<double>& values, double low, double high);

/// RFC 4648, with padding.
std::string Base64(const std::string& bytes);

/// A map as the viewer in assets/ reads it: numbers of elements, boxes, cones, and in "data" the
/// deflated lists in base64: x, y, z of the vertices, u, v of the points (of the sphere u, v, w), two colours a face (16
/// bits each, from the low to the high end of the box or the colour scale), then the vertex of each
/// point, the point of each corner, seams and boundary (32 bits each). Vertices are renumbered in
/// the order in which the corners meet them. Of a map on a lattice "lattice" has a period of its pattern
/// (PatternTile, deflated, in base64) and how the plane leads into it.
nlohmann::json MapPayload(const UvMap& map);

/// The colour scales of the two measures that the viewer shows, of the same ranges for every map:
/// name, meaning, least, greatest, and colours "#rrggbb" from one end to the other.
nlohmann::json ColourScales();

}  // namespace cirque
