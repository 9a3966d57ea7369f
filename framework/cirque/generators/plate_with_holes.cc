#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "cirque/generators/generators.h"
#include "cirque/generators/surface_chart.h"

namespace cirque {
namespace {

using Eigen::Vector2d;

constexpr Index kMinLoopVertices = 12;
constexpr double kRounding = 1e-9;
constexpr double kNarrowest = 0.1;  ///< of what lies between two holes: clearances stay below it

double QuarticNorm(const Vector2d& p) {
  return std::sqrt(std::hypot(p.x() * p.x(), p.y() * p.y()));
}

/// The outline at an angle.
Vector2d Outline(double turns) {
  const Vector2d p(std::cos(2 * kPi * turns), std::sin(2 * kPi * turns));
  return p / QuarticNorm(p);
}

Vector2d OnEllipse(const EllipticHole& hole, double turns) {
  const Vector2d p(hole.axes.x() * std::cos(2 * kPi * turns),
                   hole.axes.y() * std::sin(2 * kPi * turns));
  return hole.centre + Eigen::Rotation2Dd(hole.angle) * p;
}

/// Delaunay triangles without those inside the holes, whose corners all are one hole's.
std::vector<Triangle> TriangulateOutsideHoles(const std::vector<Vector2d>& points) {
  std::vector<Triangle> triangles = TriangulateHull(points);
  std::erase_if(triangles, [&](const Triangle& t) {
    return std::any_of(PlateHoles().begin(), PlateHoles().end(), [&](const EllipticHole& hole) {
      return std::all_of(t.begin(), t.end(),
                         [&](Index v) { return hole.Norm(points[v]) < 1 + kRounding; });
    });
  });
  return triangles;
}

}  // namespace

double EllipticHole::Norm(const Vector2d& point, double grown) const {
  const Vector2d p = Eigen::Rotation2Dd(-angle) * (point - centre);
  return std::hypot(p.x() / (axes.x() + grown), p.y() / (axes.y() + grown));
}

const std::array<EllipticHole, 5>& PlateHoles() {
  static const std::array<EllipticHole, 5> kHoles = {{{{0, 0}, {0.2, 0.13}, 0.3},
                                                      {{0.52, 0.45}, {0.2, 0.12}, 0.8},
                                                      {{-0.5, 0.5}, {0.15, 0.15}, 0},
                                                      {{-0.45, -0.5}, {0.12, 0.22}, 0.2},
                                                      {{0.5, -0.5}, {0.18, 0.11}, -0.6}}};
  return kHoles;
}

PolygonSoup PlateWithHoles(const GeneratorOptions& options) {
  SurfaceChart chart;
  chart.position = [](double a, double b) -> Vector2d { return a * Outline(b); };
  chart.lift = [](const Vector2d& p) { return Eigen::Vector3d(p.x(), p.y(), 0); };
  chart.flatten = [](const Eigen::Vector3d& p) -> Vector2d { return p.head<2>(); };
  chart.boundary = {Outline};
  for (const EllipticHole& hole : PlateHoles()) {
    chart.boundary.emplace_back([&hole](double t) { return OnEllipse(hole, t); });
  }
  chart.min_boundary_vertices = kMinLoopVertices;
  chart.allowed = [](const Vector2d& p, double edge_length) {
    const double clearance = kClearance * std::min(edge_length, kNarrowest);
    return QuarticNorm(p) < 1 - clearance &&
           std::all_of(PlateHoles().begin(), PlateHoles().end(),
                       [&](const EllipticHole& hole) { return hole.Norm(p, clearance) > 1; });
  };
  chart.triangulate = TriangulateOutsideHoles;
  chart.euler_characteristic = -4;
  return MeshChart(chart, options);
}

}  // namespace cirque
