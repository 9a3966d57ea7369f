#include "cirque/domains/round_circles.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/QR>

namespace cirque {
namespace {

using Complex = std::complex<double>;
using Loop = std::vector<Index>;

struct Circle {
  Complex centre;
  double radius;

  double Miss(Complex z) const { return std::abs(std::abs(z - centre) / radius - 1); }
};

/// The circle of least sum (|z - c|^2 - r^2)^2 (I. Kasa, 1976).
Circle FitCircle(const Triangulation& t, const Loop& loop, const std::vector<Complex>& place) {
  Complex mean = 0;
  for (const Index h : loop) mean += place[t.Tail(h)] / static_cast<double>(loop.size());
  Eigen::MatrixX3d rows(static_cast<Eigen::Index>(loop.size()), 3);
  Eigen::VectorXd squares(rows.rows());
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    const Complex z = place[t.Tail(loop[k])] - mean;
    rows.row(k) << 2 * z.real(), 2 * z.imag(), 1;
    squares[k] = std::norm(z);
  }
  const Eigen::Vector3d fit = rows.colPivHouseholderQr().solve(squares);
  return {mean + Complex(fit.x(), fit.y()), std::sqrt(fit.z() + fit.head<2>().squaredNorm())};
}

}  // namespace

std::vector<Complex> MeanPlaces(const Triangulation& t, const CornerUv& uv) {
  std::vector<Complex> place(t.num_vertices);
  std::vector<double> corners(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    place[t.vertex[h]] += Complex(uv.value[h].x(), uv.value[h].y());
    corners[t.vertex[h]] += 1;
  }
  for (Index v = 0; v < t.num_vertices; ++v) place[v] /= corners[v];
  return place;
}

RoundHolesSummary PutOnCircles(const Triangulation& t, const std::vector<Loop>& loops,
                               std::vector<Complex>* place) {
  RoundHolesSummary summary;
  summary.holes = static_cast<int>(loops.size()) - 1;
  const Circle outer = FitCircle(t, loops[0], *place);
  for (Complex& z : *place) z = (z - outer.centre) / outer.radius;
  double roundness = 0, error = 0;
  for (const Loop& loop : loops) {
    const bool is_outer = &loop == &loops[0];
    const Circle circle = is_outer ? Circle{0, 1} : FitCircle(t, loop, *place);
    for (const Index h : loop) {
      Complex& z = (*place)[t.Tail(h)];
      roundness = std::max(roundness, circle.Miss(z));
      z = circle.centre + circle.radius / std::abs(z - circle.centre) * (z - circle.centre);
      error = std::max(error, circle.Miss(z));
    }
    if (is_outer) continue;
    const bool first = &loop == &loops[1];
    if (first || circle.radius < summary.smallest_radius) summary.smallest_radius = circle.radius;
    if (first || circle.radius > summary.largest_radius) summary.largest_radius = circle.radius;
  }
  summary.roundness = roundness;
  summary.circle_error = error;
  return summary;
}

}  // namespace cirque
