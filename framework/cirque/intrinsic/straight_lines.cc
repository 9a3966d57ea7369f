#include "cirque/intrinsic/straight_lines.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {
namespace {

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

using Point = std::complex<double>;

double Cross(Point a, Point b) { return a.real() * b.imag() - a.imag() * b.real(); }

/// The faces along a path in the plane, where it starts at 0.
struct Strip {
  std::vector<Point> tail, tip;  // of the halfedges crossed
  Point end;
};

Strip Unfold(const Triangulation& t, const EdgeLengths& lengths, const CornerAngles& angles,
             const EdgePath& path) {
  Strip strip;
  const auto length = [&](Index h) { return lengths.value[t.edge[h]]; };
  const Index first = path.crossed.front();
  strip.tail.push_back(length(Prev(first)));
  strip.tip.push_back(std::polar(length(Next(first)), angles.value[first]));
  for (std::size_t i = 0;; ++i) {
    const Index in = t.twin[path.crossed[i]];
    const Point from = strip.tip[i], to = strip.tail[i];
    const Point apex = from + (to - from) / std::abs(to - from) *
                                  std::polar(length(Prev(in)), angles.value[Next(in)]);
    if (i + 1 == path.crossed.size()) {
      strip.end = apex;
      return strip;
    }
    const bool round_tail = path.crossed[i + 1] == Prev(in);
    strip.tail.push_back(round_tail ? apex : to);
    strip.tip.push_back(round_tail ? from : apex);
  }
}

}  // namespace

PositionRule StraightLines(const Triangulation& other, const EdgeLengths& lengths) {
  return [&other, &lengths,
          angles = MeasureCornerAngles(other, lengths)](const EdgePath& path) -> PathPositions {
    const Strip strip = Unfold(other, lengths, angles, path);
    PathPositions positions;
    for (std::size_t i = 0; i < strip.tail.size(); ++i) {
      const double tail = Cross(strip.end, strip.tail[i]), tip = Cross(strip.end, strip.tip[i]);
      const double s = tail == tip ? 0.5 : std::clamp(tail / (tail - tip), 0.0, 1.0);
      const Point at = strip.tail[i] + s * (strip.tip[i] - strip.tail[i]);
      positions.along_crossed.push_back(s);
      positions.along_input.push_back(
          std::clamp((std::conj(strip.end) * at).real() / std::norm(strip.end), 0.0, 1.0));
    }
    return positions;
  };
}

}  // namespace cirque
