#include "cirque/io/point_index.h"

#include <bit>
#include <cstdint>

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

}  // namespace cirque
