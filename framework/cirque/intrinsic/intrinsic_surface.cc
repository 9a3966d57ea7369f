#include "cirque/intrinsic/intrinsic_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glog/logging.h>

#include "cirque/core/parallel.h"
#include "cirque/math/arctangent.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

/// Kahan's mu of sides a >= b and c: positive exactly when a triangle has these sides.
double TriangleDefect(double a, double b, double c) { return b >= c ? c - (a - b) : b - (a - c); }

/// The angle opposite c [rad]. The parentheses are Kahan's and must stay: every difference is then
/// taken between numbers that are close or exact (W. Kahan, "Miscalculating Area and Angles of a
/// Needle-like Triangle", 2014).
double AngleOpposite(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  const double above = ((a - b) + c) * std::max(TriangleDefect(a, b, c), 0.0);
  const double below = (a + (b + c)) * ((a - c) + b);
  return 2 * Arctangent(std::sqrt(above), std::sqrt(std::max(below, 0.0)));
}

/// The angles of one triangle, its sides brought near 1 by a power of two so that no product
/// underflows or overflows.
std::array<double, 3> TriangleAngles(std::array<double, 3> side) {
  const auto longest = std::max_element(side.begin(), side.end());
  const int exponent = std::ilogb(*longest);
  for (double& length : side) length = std::scalbn(length, -exponent);
  const std::size_t k = longest - side.begin();
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  std::array<double, 3> angle = {0, 0, 0};
  const double a = side[k], b = std::max(side[i], side[j]), c = std::min(side[i], side[j]);
  if (!(TriangleDefect(a, b, c) > 0)) {
    angle[k] = kPi;
    return angle;
  }
  angle[i] = AngleOpposite(side[j], side[k], side[i]);
  angle[j] = AngleOpposite(side[k], side[i], side[j]);
  angle[k] = AngleOpposite(side[i], side[j], side[k]);
  return angle;
}

}  // namespace

CornerAngles MeasureCornerAngles(const Triangulation& t, const EdgeLengths& lengths) {
  CHECK_EQ(lengths.value.size(), t.num_edges());
  CornerAngles angles;
  angles.value.resize(t.num_halfedges());
  ParallelFor(t.num_faces(), [&](Index f) {
    const Index h = 3 * f;
    const std::array<double, 3> angle = TriangleAngles(
        {lengths.value[t.edge[h]], lengths.value[t.edge[h + 1]], lengths.value[t.edge[h + 2]]});
    for (int k = 0; k < 3; ++k) angles.value[h + k] = angle[k];
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
           std::sin(surface.angles.value[3 * f + 2]);
  });
}

}  // namespace cirque
