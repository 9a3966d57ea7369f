#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/generators/generators.h"
#include "cirque/generators/known_maps.h"
#include "cirque/generators/surface_chart.h"

namespace cirque {
namespace {

constexpr Index kMinCircleVertices = 6;

/// The share of a circle's radius that interior vertices keep away from it; the circle is conformal
/// to one of radius `space_radius` on the surface.
double RelativeClearance(double edge_length, double space_radius) {
  return kClearance * std::min(edge_length / space_radius, 2 * kPi / kMinCircleVertices);
}

Eigen::Vector2d OnCircle(double radius, double turns) {
  return {radius * std::cos(2 * kPi * turns), radius * std::sin(2 * kPi * turns)};
}

/// A conformal chart on the disk whose radius is `radius(1)`; `radius` rises from 0 on [0, 1], and
/// the disk's circle lies on the surface as one of radius `rim`.
SurfaceChart DiskChart(const ConformalMap& map, const std::function<double(double)>& radius,
                       double rim) {
  SurfaceChart chart;
  chart.position = [radius](double a, double b) { return OnCircle(radius(a), b); };
  chart.lift = map.to_surface;
  chart.flatten = map.to_plane;
  const double outer = radius(1);
  chart.boundary = {[outer](double t) { return OnCircle(outer, t); }};
  chart.min_boundary_vertices = kMinCircleVertices;
  chart.allowed = [outer, rim](const Eigen::Vector2d& w, double edge_length) {
    return w.norm() < outer * (1 - RelativeClearance(edge_length, rim));
  };
  chart.triangulate = TriangulateHull;
  return chart;
}

/// Delaunay triangles without those inside the circle of radius `hole`. The chords of its vertices
/// are Delaunay edges because the circle is empty.
std::vector<Triangle> TriangulateAround(double hole, const std::vector<Eigen::Vector2d>& points) {
  constexpr double kRounding = 1e-9;
  std::vector<Triangle> triangles = TriangulateHull(points);
  std::erase_if(triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](Index v) { return points[v].norm() < hole * (1 + kRounding); });
  });
  return triangles;
}

/// A conformal chart on the ring from radius(0) > 0 to radius(1), circles that lie on the surface
/// with the radii `inner_rim` and `rim`.
SurfaceChart RingChart(const ConformalMap& map, const std::function<double(double)>& radius,
                       double inner_rim, double rim) {
  SurfaceChart chart = DiskChart(map, radius, rim);
  const double inner = radius(0);
  chart.boundary.emplace_back([inner](double t) { return OnCircle(inner, t); });
  const auto inside = chart.allowed;
  chart.allowed = [=](const Eigen::Vector2d& w, double edge_length) {
    return inside(w, edge_length) &&
           w.norm() > inner * (1 + RelativeClearance(edge_length, inner_rim));
  };
  chart.triangulate = [inner](const std::vector<Eigen::Vector2d>& points) {
    return TriangulateAround(inner, points);
  };
  chart.euler_characteristic = 0;
  return chart;
}

PolygonSoup SphericalPart(double polar_angle, const GeneratorOptions& options) {
  const auto radius = [polar_angle](double a) { return std::tan(a * polar_angle / 2); };
  return MeshChart(DiskChart(StereographicMap(), radius, std::sin(polar_angle)), options);
}

PolygonSoup Tube(double length, const GeneratorOptions& options) {
  const auto radius = [length](double a) {
    const double meridian = a * (kPi / 2 + length);
    return meridian < kPi / 2 ? std::tan(meridian / 2) : std::exp(meridian - kPi / 2);
  };
  return MeshChart(DiskChart(CappedTubeMap(), radius, 1), options);
}

}  // namespace

PolygonSoup SphericalCap(const GeneratorOptions& options) {
  return SphericalPart(kPi / 3, options);
}

PolygonSoup Hemisphere(const GeneratorOptions& options) { return SphericalPart(kPi / 2, options); }

PolygonSoup EnneperPatch(const GeneratorOptions& options) {
  // The rim is no circle of the surface, but 2 pi times 1 + |w|^2 = 2 long.
  return MeshChart(DiskChart(
                       EnneperMap(), [](double a) { return a; }, 2),
                   options);
}

PolygonSoup CappedTube(const GeneratorOptions& options) { return Tube(8, options); }

PolygonSoup LongCappedTube(const GeneratorOptions& options) { return Tube(50, options); }

PolygonSoup Annulus(const GeneratorOptions& options) {
  const auto radius = [](double a) { return 0.4 + 0.6 * a; };
  return MeshChart(RingChart(IdentityMap(), radius, 0.4, 1), options);
}

PolygonSoup Catenoid(const GeneratorOptions& options) {
  constexpr double kHeight = 1.2;
  const auto radius = [](double a) { return std::exp(kHeight * (2 * a - 1)); };
  return MeshChart(RingChart(CatenoidMap(), radius, std::cosh(kHeight), std::cosh(kHeight)),
                   options);
}

/// From the concentric ring of radii q and 1, so that triangles are round where the ring is thin.
PolygonSoup EccentricAnnulus(const GeneratorOptions& options) {
  SurfaceChart chart = RingChart(
      EccentricAnnulusMap(), [](double a) { return std::pow(kEccentricConformalRadius, 1 - a); },
      kEccentricRadius, 1);
  chart.allowed = [lift = chart.lift](const Eigen::Vector2d& w, double edge_length) {
    const double clearance = kClearance * std::min(edge_length, kEccentricRadius);
    const Eigen::Vector2d z = lift(w).head<2>();
    return z.norm() < 1 - clearance &&
           (z - Eigen::Vector2d(kEccentricShift, 0)).norm() > kEccentricRadius + clearance;
  };
  return MeshChart(chart, options);
}

}  // namespace cirque
