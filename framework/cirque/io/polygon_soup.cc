#include "cirque/io/polygon_soup.h"

#include <bit>

#include <fmt/format.h>

#include "cirque/core/count.h"
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

void PassedOver::Warn(PolygonSoup* soup) const {
  if (count_ == 0) return;
  const std::string more =
      count_ > 1 ? fmt::format(" (and {} more)", Count(count_ - 1, "time")) : "";
  soup->warnings.push_back(first_ + ": " + what_ + more);
}

namespace {

bool SameBits(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::bit_cast<std::uint64_t>(a.x()) == std::bit_cast<std::uint64_t>(b.x()) &&
         std::bit_cast<std::uint64_t>(a.y()) == std::bit_cast<std::uint64_t>(b.y());
}

}  // namespace

SplitVertices SplitAtSeams(const PolygonSoup& mesh) {
  SplitVertices split;
  split.vertex.resize(mesh.position.size());
  for (std::size_t v = 0; v < split.vertex.size(); ++v) split.vertex[v] = static_cast<Index>(v);
  split.texture.assign(mesh.position.size(), kNone);
  split.corner = mesh.corner;
  std::vector<Index> next(mesh.position.size(), kNone);  // the next copy of the same vertex
  for (std::size_t c = 0; c < mesh.corner.size(); ++c) {
    const Index texture = mesh.corner_texture[c];
    if (texture == kNone) continue;
    Index& mine = split.corner[c];
    if (split.texture[mine] == kNone) split.texture[mine] = texture;
    while (!SameBits(mesh.texture[split.texture[mine]], mesh.texture[texture])) {
      if (next[mine] == kNone) {
        next[mine] = static_cast<Index>(split.vertex.size());
        split.vertex.push_back(mesh.corner[c]);
        split.texture.push_back(texture);
        next.push_back(kNone);
      }
      mine = next[mine];
    }
  }
  return split;
}

void WritePointsAndPolygons(const PolygonSoup& mesh, const SplitVertices* split, TextWriter* out) {
  if (split) {
    out->Lines(static_cast<int>(split->vertex.size()), [&](int v, TextWriter* line) {
      Eigen::Matrix<double, 5, 1> numbers = Eigen::Matrix<double, 5, 1>::Zero();
      numbers.head<3>() = mesh.position[split->vertex[v]];
      if (split->texture[v] != kNone) numbers.tail<2>() = mesh.texture[split->texture[v]];
      line->PointLine(numbers);
    });
  } else {
    out->Lines(static_cast<int>(mesh.position.size()),
               [&](int v, TextWriter* line) { line->PointLine(mesh.position[v]); });
  }
  const std::vector<Index>& corner = split ? split->corner : mesh.corner;
  out->Lines(mesh.num_polygons(), [&](int p, TextWriter* line) {
    line->Number(mesh.first_corner[p + 1] - mesh.first_corner[p]);
    for (Index c = mesh.first_corner[p]; c < mesh.first_corner[p + 1]; ++c) {
      line->Text(" ");
      line->Number(corner[c]);
    }
    line->Text("\n");
  });
}

}  // namespace cirque
