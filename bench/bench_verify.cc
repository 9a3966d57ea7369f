// verify_map's verdict on maps that a method of pairs would take quadratic time for: items per
// second should hardly fall from line to line.
#include <cmath>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <glog/logging.h>

#include "cirque/verify/map_check.h"

namespace cirque::verify {
namespace {

using Eigen::Vector2d;

/// A mesh in the plane z = height, its own map.
class Sketch {
 public:
  Index Point(const Vector2d& p, double height) {
    soup_.position.emplace_back(p.x(), p.y(), height);
    soup_.texture.push_back(p);
    return static_cast<Index>(soup_.position.size()) - 1;
  }
  void Face(const std::vector<Index>& corners) {
    soup_.corner.insert(soup_.corner.end(), corners.begin(), corners.end());
    soup_.first_corner.push_back(static_cast<Index>(soup_.corner.size()));
  }
  PolygonSoup Map() && {
    soup_.corner_texture = soup_.corner;
    return std::move(soup_);
  }

 private:
  PolygonSoup soup_;
};

Vector2d OnCircle(int i, int n, double radius) {
  return radius * Vector2d(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n));
}

/// n triangles round one vertex.
PolygonSoup Wheel(int n) {
  Sketch sketch;
  const Index hub = sketch.Point({0, 0}, 1);
  for (int i = 0; i < n; ++i) sketch.Point(OnCircle(i, n, 1), 0);
  for (int i = 0; i < n; ++i) sketch.Face({hub, 1 + i, 1 + (i + 1) % n});
  return std::move(sketch).Map();
}

/// The same triangles, each a patch of its own that touches all others at one point.
PolygonSoup TornWheel(int n) {
  Sketch sketch;
  for (int i = 0; i < n; ++i) {
    const Index hub = sketch.Point({0, 0}, i);
    const Index a = sketch.Point(OnCircle(i, n, 1), i), b = sketch.Point(OnCircle(i + 1, n, 1), i);
    sketch.Face({hub, a, b});
  }
  return std::move(sketch).Map();
}

/// n rings of eight triangles, each in the hole of the next: all bounding boxes hold the centre.
PolygonSoup Nested(int n) {
  Sketch sketch;
  for (int ring = 1; ring <= n; ++ring) {
    std::vector<Index> inner, outer;
    for (int i = 0; i < 4; ++i) inner.push_back(sketch.Point(OnCircle(i, 4, ring), ring));
    for (int i = 0; i < 4; ++i) outer.push_back(sketch.Point(OnCircle(i, 4, ring + 0.5), ring));
    for (int i = 0; i < 4; ++i) {
      const int next = (i + 1) % 4;
      sketch.Face({inner[i], outer[i], outer[next]});
      sketch.Face({inner[i], outer[next], inner[next]});
    }
  }
  return std::move(sketch).Map();
}

/// One convex polygon of n corners.
PolygonSoup Polygon(int n) {
  Sketch sketch;
  std::vector<Index> corners;
  for (int i = 0; i < n; ++i) corners.push_back(sketch.Point(OnCircle(i, n, 1), 0));
  sketch.Face(corners);
  return std::move(sketch).Map();
}

/// A vertex for every corner, in reverse order: matched by position.
PolygonSoup Unwelded(const PolygonSoup& map) {
  PolygonSoup split = map;
  const auto n = static_cast<Index>(map.corner.size());
  split.position.resize(n);
  split.texture.resize(n);
  for (Index c = 0; c < n; ++c) {
    split.corner[c] = n - 1 - c;
    split.position[n - 1 - c] = map.position[map.corner[c]];
    split.texture[n - 1 - c] = map.texture[map.corner_texture[c]];
  }
  split.corner_texture = split.corner;
  return split;
}

void TimeVerdict(benchmark::State& state, PolygonSoup (*make)(int), bool unwelded) {
  const PolygonSoup in = make(static_cast<int>(state.range(0)));
  const PolygonSoup out = unwelded ? Unwelded(in) : in;
  VerifyOptions options;
  options.require_injective = true;
  for (auto _ : state) {
    const StatusOr<MapReport> report = VerifyMap(in, out, options);
    CHECK(report.ok() && report->valid());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

#define CIRQUE_TIME(name, make, unwelded)              \
  BENCHMARK_CAPTURE(TimeVerdict, name, make, unwelded) \
      ->RangeMultiplier(10)                            \
      ->Range(1000, 100000)                            \
      ->Unit(benchmark::kMillisecond)
CIRQUE_TIME(wheel, Wheel, false);
CIRQUE_TIME(torn_wheel, TornWheel, false);
CIRQUE_TIME(nested_rings, Nested, false);
CIRQUE_TIME(one_polygon, Polygon, false);
CIRQUE_TIME(renumbered_wheel, Wheel, true);
#undef CIRQUE_TIME

}  // namespace
}  // namespace cirque::verify
