#include "cirque/intrinsic/metric_delaunay.h"

#include <utility>

namespace cirque {

IntrinsicTriangulation MakeDelaunayOfMetric(const Triangulation& t, const EdgeLengths& lengths,
                                            std::vector<bool> locked) {
  constexpr double kAnyAngle = 1e9;  // an angle sum is less [rad]
  const auto n = static_cast<std::size_t>(t.num_vertices);
  const ConeTargets any{std::vector<double>(n, 0), std::vector<double>(n, kAnyAngle)};
  return MakeIntrinsicDelaunay(t, lengths, {&any, std::move(locked)});
}

}  // namespace cirque
