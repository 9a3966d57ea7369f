#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Random numbers that are the same on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  /// From 0 to n - 1.
  int Below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  /// From least to most, both included.
  int Between(int least, int most) { return least + Below(most - least + 1); }
  double Uniform(double lower, double upper) {
    return lower + (upper - lower) * 0x1p-53 * static_cast<double>(engine_() >> 11);
  }
  /// A power of ten whose exponent is uniform.
  double Power(double least_exponent, double most_exponent);
  bool Chance(double probability) { return Uniform(0, 1) < probability; }

 private:
  std::mt19937_64 engine_;
};

/// A way to make surfaces that are hard to map.
struct SmallSurfaceKind {
  std::string name;
  PolygonSoup (*make)(Dice* dice);
};

/// Up to a few hundred triangles each: needles, fans, polygons without inner vertices, spikes,
/// slivers, bands, polyhedra, tori, triangles split in three, small meshes of every generator.
const std::vector<SmallSurfaceKind>& SmallSurfaceKinds();

}  // namespace cirque
