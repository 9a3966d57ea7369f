#include "cirque/io/polygon_soup.h"

#include <bit>

#include <fmt/format.h>

#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

/// Mixes the bits of the coordinates (the finaliser of MurmurHash3).
std::uint64_t Hash(const Eigen::Vector3d& point) {
  std::uint64_t hash = 0;
  for (const double coordinate : point) {
    hash ^= std::bit_cast<std::uint64_t>(coordinate + 0.0);  // + 0.0 turns -0 into 0
    hash = (hash ^ (hash >> 33)) * 0xff51afd7ed558ccdULL;
    hash = (hash ^ (hash >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    hash ^= hash >> 33;
  }
  return hash;
}

}  // namespace

std::string AddPolygon(const std::vector<std::int64_t>& corners, PolygonSoup* soup) {
  if (corners.size() < 3) {
    return fmt::format("a face needs at least 3 corners, this one has {}; complete or remove it",
                       corners.size());
  }
  const auto num_vertices = static_cast<std::int64_t>(soup->position.size());
  for (const std::int64_t v : corners) {
    if (v < 0 || v >= num_vertices) {
      return fmt::format("expected a vertex index from 0 to {}, got {}; correct the index",
                         num_vertices - 1, v);
    }
  }
  for (const std::int64_t v : corners) soup->corner.push_back(static_cast<Index>(v));
  soup->first_corner.push_back(static_cast<Index>(soup->corner.size()));
  return "";
}

std::vector<Index> FirstOfEqualPoints(const std::vector<Eigen::Vector3d>& points) {
  const std::size_t mask = std::bit_ceil(2 * points.size() + 1) - 1;
  std::vector<Index> table(mask + 1, kNone);  // open addressing, at most half full
  std::vector<Index> first(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    first[i] = static_cast<Index>(i);
    if (!points[i].allFinite()) continue;
    std::size_t slot = Hash(points[i]) & mask;
    while (table[slot] != kNone && points[table[slot]] != points[i]) slot = (slot + 1) & mask;
    if (table[slot] == kNone) table[slot] = static_cast<Index>(i);
    first[i] = table[slot];
  }
  return first;
}

void WritePointsAndPolygons(const PolygonSoup& mesh, TextWriter* out) {
  out->Lines(static_cast<int>(mesh.position.size()),
             [&](int v, TextWriter* line) { line->PointLine(mesh.position[v]); });
  out->Lines(mesh.num_polygons(), [&](int p, TextWriter* line) {
    line->Number(mesh.first_corner[p + 1] - mesh.first_corner[p]);
    for (Index c = mesh.first_corner[p]; c < mesh.first_corner[p + 1]; ++c) {
      line->Text(" ");
      line->Number(mesh.corner[c]);
    }
    line->Text("\n");
  });
}

}  // namespace cirque
