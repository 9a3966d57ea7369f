#include "cirque/intrinsic/intrinsic_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <glog/logging.h>

#include "cirque/core/parallel.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/math/elementary.h"
#include "cirque/math/elementary_arrays.h"
#include "cirque/math/parallel_chunks.h"

namespace cirque {
namespace {

/// Kahan's mu of sides a >= b and c: positive exactly when a triangle has these sides.
double TriangleDefect(double a, double b, double c) { return b >= c ? c - (a - b) : b - (a - c); }

/// The sides of a right triangle, of which half the angle opposite c is.
struct HalfAngleSides {
  double opposite, adjacent;
};

/// The parentheses are Kahan's and must stay: every difference is then taken between numbers that are
/// close or exact (W. Kahan, "Miscalculating Area and Angles of a Needle-like Triangle", 2014).
HalfAngleSides SidesOpposite(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  const double above = ((a - b) + c) * std::max(TriangleDefect(a, b, c), 0.0);
  const double below = (a + (b + c)) * ((a - c) + b);
  return {std::sqrt(above), std::sqrt(std::max(below, 0.0))};
}

/// Those of one triangle, its sides brought near 1 by a power of two where a product might underflow or
/// overflow.
std::array<HalfAngleSides, 3> TriangleHalfAngles(std::array<double, 3> side) {
  constexpr double kLarge = 0x1p400;
  const auto longest = std::max_element(side.begin(), side.end());
  if (!(*longest<kLarge&& * longest> 1 / kLarge)) {
    const int exponent = std::ilogb(*longest);
    for (double& length : side) length = std::scalbn(length, -exponent);
  }
  const std::size_t k = longest - side.begin();
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  const double a = side[k], b = std::max(side[i], side[j]), c = std::min(side[i], side[j]);
  std::array<HalfAngleSides, 3> half;
  if (!(TriangleDefect(a, b, c) > 0)) {
    half.fill({0, 1});
    half[k] = {1, 0};
    return half;
  }
  half[i] = SidesOpposite(side[j], side[k], side[i]);
  half[j] = SidesOpposite(side[k], side[i], side[j]);
  half[k] = SidesOpposite(side[i], side[j], side[k]);
  return half;
}

}  // namespace

CornerAngles MeasureCornerAngles(const Triangulation& t, const EdgeLengths& lengths) {
  CHECK_EQ(lengths.value.size(), t.num_edges());
  CornerAngles angles;
  angles.value.resize(t.num_halfedges());
  ParallelChunks(t.num_faces(), [&](Index first, Index end) {
    ChunkOf<double, 3> opposite(end - first), adjacent(end - first);
    for (Index f = first; f < end; ++f) {
      const Index h = 3 * f;
      const auto half = TriangleHalfAngles(
          {lengths.value[t.edge[h]], lengths.value[t.edge[h + 1]], lengths.value[t.edge[h + 2]]});
      for (int k = 0; k < 3; ++k) {
        opposite[h + k - 3 * first] = half[k].opposite;
        adjacent[h + k - 3 * first] = half[k].adjacent;
      }
    }
    const std::span<double> angle(&angles.value[3 * first], opposite.size());
    Arctangents(opposite, adjacent, angle);
    for (double& a : angle) a *= 2;
  });
  return angles;
}

std::vector<double> VertexAngleSums(const Triangulation& t, const CornerAngles& angles) {
  std::vector<double> sum(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) sum[t.vertex[h]] += angles.value[h];
  return sum;
}

IntrinsicSurface MeasureSurface(const Triangulation& t, const EdgeLengths& lengths) {
  return {t, lengths, MeasureCornerAngles(t, lengths), BoundaryVertices(t), CornersPerVertex(t)};
}

double SurfaceArea(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  const Eigen::VectorXd& length = surface.lengths.value;
  return ParallelSum(t.num_faces(), [&](Index f) {
    return 0.5 * length[t.edge[3 * f]] * length[t.edge[3 * f + 1]] *
           SineToPi(surface.angles.value[3 * f + 2]);
  });
}

}  // namespace cirque
