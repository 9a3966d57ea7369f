#include "cirque/pipeline/flat_metric.h"

#include <cmath>
#include <vector>

namespace cirque {
namespace {

constexpr double kRounding = 1e-10;    ///< [rad]
constexpr double kLeastCorner = 1e-7;  ///< [rad]: squares of less are rounding

bool HasPattern(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  const Eigen::VectorXd& alpha = surface.angles.value;
  if (!(alpha.minCoeff() > kLeastCorner)) return false;
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    if (g != kNone && alpha[h] + alpha[g] > kPi + kRounding) return false;
  }
  return true;
}

/// The circumradius of a face by the law of sines, of the corner whose sine is the largest.
double LogCircumradius(const IntrinsicSurface& surface, Index face) {
  Index widest = 3 * face;
  const auto sine = [&](Index h) { return std::sin(surface.angles.value[h]); };
  for (Index h = 3 * face + 1; h < 3 * face + 3; ++h) {
    if (sine(h) > sine(widest)) widest = h;
  }
  const double length = surface.lengths.value[surface.triangulation.edge[widest]];
  return std::log(length / (2 * sine(widest)));
}

}  // namespace

bool HasAngleSums(const IntrinsicSurface& surface, const ConeTargets& targets) {
  const Triangulation& t = surface.triangulation;
  std::vector<bool> seen(t.num_vertices, false);
  // Vertex by vertex, since of most surfaces one of the first decides.
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index v = t.vertex[h];
    if (seen[v]) continue;
    seen[v] = true;
    double sum = 0;
    t.ForEachCornerAround(h, [&](Index corner) { sum += surface.angles.value[corner]; });
    if (sum < targets.lower[v] - kRounding || sum > targets.upper[v] + kRounding) return false;
  }
  return true;
}

std::optional<FlatMetric> FlatMetricOf(const IntrinsicSurface& surface,
                                       const ConeTargets& targets) {
  if (!HasAngleSums(surface, targets) || !HasPattern(surface)) return {};
  FlatMetric flat{{surface.angles.value, 0}, {}};
  flat.log_radii.value.resize(surface.triangulation.num_faces());
  for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
    flat.log_radii.value[f] = LogCircumradius(surface, f);
  }
  return flat;
}

}  // namespace cirque
