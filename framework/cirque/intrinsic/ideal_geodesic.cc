#include "cirque/intrinsic/ideal_geodesic.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "cirque/math/log_triangle.h"

namespace cirque {
namespace {

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

/// A light-like vector by its coordinates in the three of the first face: that of the vertex where
/// the geodesic begins, those of the tail and the tip of the side that it leaves by.
using LightVector = Eigen::Vector3d;

/// The volume of the vector with the first one and another, up to a factor.
double Volume(const LightVector& a, const LightVector& b) { return a[1] * b[2] - a[2] * b[1]; }

/// The ends of the edges crossed, and the vertex where the geodesic ends.
struct LightStrip {
  std::vector<LightVector> tail, tip;
  LightVector end;
  Index end_vertex = kNone;
};

/// The vector of the vertex beyond halfedge h, from those of h's face.
LightVector Beyond(const Triangulation& t, const EdgeLengths& lengths, Index h,
                   const LightVector& tail, const LightVector& tip, const LightVector& third) {
  const double base = lengths.value[t.edge[h]];
  const auto ratio = [&](Index side) { return lengths.value[t.edge[side]] / base; };
  const Index in = t.twin[h];  // from the tip to the tail
  const double to_tail = ratio(Next(in)), to_tip = ratio(Prev(in));
  const double from_tail = ratio(Prev(h)), from_tip = ratio(Next(h));
  const double g = (to_tail / from_tail) * (to_tip / from_tip);
  return (to_tail * to_tail + g * from_tail * from_tail) * tip +
         (to_tip * to_tip + g * from_tip * from_tip) * tail - g * third;
}

LightStrip Develop(const Triangulation& t, const EdgeLengths& lengths,
                   std::span<const Index> crossed) {
  LightStrip strip;
  LightVector third = LightVector::UnitX();
  strip.tail.push_back(LightVector::UnitY());
  strip.tip.push_back(LightVector::UnitZ());
  for (std::size_t i = 0;; ++i) {
    const LightVector tail = strip.tail[i], tip = strip.tip[i];
    const LightVector apex = Beyond(t, lengths, crossed[i], tail, tip, third);
    const Index in = t.twin[crossed[i]];
    if (i + 1 == crossed.size()) {
      strip.end = apex;
      strip.end_vertex = t.vertex[in];
      return strip;
    }
    const bool round_tip = crossed[i + 1] == Prev(in);
    third = round_tip ? tail : tip;
    strip.tail.push_back(round_tip ? apex : tail);
    strip.tip.push_back(round_tip ? tip : apex);
  }
}

/// What rounding and overflow leave of a fraction: 1/2 where it is undefined.
double Fraction(double x) { return std::isnan(x) ? 0.5 : std::clamp(x, 0.0, 1.0); }

}  // namespace

PathPositions TraceIdealGeodesic(const Triangulation& t, const EdgeLengths& lengths,
                                 const Eigen::VectorXd& log_scale, const EdgePath& path) {
  const LightStrip strip = Develop(t, lengths, path.crossed);
  const LightVector& end = strip.end;
  const int larger = std::abs(end[1]) > std::abs(end[2]) ? 1 : 2;
  const double start_scale = log_scale[t.vertex[path.corner]];
  const double end_scale = log_scale[strip.end_vertex], log_ratio = start_scale - end_scale;
  PathPositions positions;
  for (std::size_t i = 0; i < path.crossed.size(); ++i) {
    const double tail = Volume(end, strip.tail[i]), tip = Volume(end, strip.tip[i]);
    const double s = Fraction(tail / (tail - tip));
    positions.along_crossed.push_back(s);
    // The same point between the ends of the geodesic, whose vectors are taken back to unscaled.
    const LightVector point = (1 - s) * strip.tail[i] + s * strip.tip[i];
    const double of_end = std::max(point[larger] / end[larger], 0.0);
    const double of_start = std::max(point[0] - of_end * end[0], 0.0);
    const double log_start = std::log(of_start), log_end = std::log(of_end);
    const double log_odds = log_end - log_start - log_ratio;
    positions.along_input.push_back(Fraction(1 / (1 + std::exp(-log_odds))));
    const double weight = -LogAddExp(log_start + start_scale, log_end + end_scale);
    positions.log_weight.push_back(std::isfinite(weight) ? weight
                                                         : -0.5 * (start_scale + end_scale));
  }
  return positions;
}

PositionRule IdealGeodesics(const Triangulation& t, const EdgeLengths& lengths,
                            const Eigen::VectorXd& log_scale) {
  return [&t, &lengths, &log_scale](const EdgePath& path) {
    return TraceIdealGeodesic(t, lengths, log_scale, path);
  };
}

}  // namespace cirque
