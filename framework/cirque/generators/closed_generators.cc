#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glog/logging.h>

#include "cirque/generators/generators.h"
#include "cirque/generators/known_maps.h"
#include "cirque/generators/planar_delaunay.h"
#include "cirque/generators/surface_chart.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The Delaunay triangulation of the sphere, which is the convex hull, of stereographic points; the
/// first one is the pole, at infinity, so that the triangles at infinity become its star: the
/// projection takes circles to circles and those through the pole to lines.
std::vector<Triangle> TriangulateSphere(const std::vector<Vector2d>& points) {
  auto triangles = ClosedPlanarDelaunay({points.begin() + 1, points.end()});
  CHECK(triangles.ok()) << triangles.status().message();
  static_assert(kNone + 1 == 0);
  for (Triangle& triangle : *triangles) {
    for (Index& v : triangle) ++v;
  }
  return *std::move(triangles);
}

/// A chart of a surface that is star-shaped about the origin, at the distance `radius(direction)`.
SurfaceChart SphereChart(const std::function<double(const Vector3d&)>& radius) {
  // Interior vertices keep this share of an edge length from the pole; near it, a point at distance
  // d has the plane radius 2 / d.
  constexpr double kPoleClearance = 0.4;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const ConformalMap map = StereographicMap();
  SurfaceChart chart;
  chart.position = [](double a, double b) -> Vector2d {
    return std::tan(a * kPi / 2) * Vector2d(std::cos(2 * kPi * b), std::sin(2 * kPi * b));
  };
  chart.lift = [map, radius](const Vector2d& w) -> Vector3d {
    const Vector3d direction = w.allFinite() ? map.to_surface(w) : Vector3d(0, 0, -1);
    return radius(direction) * direction;
  };
  chart.flatten = map.to_plane;
  chart.allowed = [](const Vector2d& w, double edge_length) {
    return w.norm() < 2 / (kPoleClearance * edge_length);
  };
  chart.fixed = {Vector2d(kInfinity, kInfinity)};
  chart.triangulate = TriangulateSphere;
  chart.euler_characteristic = 2;
  return chart;
}

SurfaceChart TorusChart() {
  const ConformalMap map = TorusMap();
  const Vector2d periods = TorusPeriods();
  SurfaceChart chart;
  chart.position = [periods](double a, double b) {
    return Vector2d((a - 0.5) * periods.x(), (b - 0.5) * periods.y());
  };
  chart.lift = map.to_surface;
  chart.flatten = map.to_plane;
  chart.allowed = [](const Vector2d&, double) { return true; };
  chart.triangulate = [periods](const std::vector<Vector2d>& points) {
    return PeriodicDelaunay(points, periods);
  };
  chart.euler_characteristic = 0;
  return chart;
}

/// Where DoubleTorus cuts the torus: x = kCut.
constexpr double kCut = 1.15;

/// The torus' oval in the plane x = kCut, [0, 1) -> plane of TorusMap. With the tube angle
/// q = q_max sin(2 pi t) both halves of cos p = kCut / (R + r cos q) join smoothly.
Vector2d CutOval(double t) {
  const double widest = std::acos((kCut - kTorusMajorRadius) / kTorusMinorRadius);
  const double q = widest * std::sin(2 * kPi * t);
  const double distance = kTorusMajorRadius + kTorusMinorRadius * std::cos(q);
  const double p = std::copysign(std::acos(std::min(1., kCut / distance)), std::cos(2 * kPi * t));
  return TorusMap().to_plane(
      {distance * std::cos(p), distance * std::sin(p), kTorusMinorRadius * std::sin(q)});
}

/// The part of the torus with x <= kCut: one handle, one loop.
SurfaceChart CutTorusChart() {
  constexpr double kRounding = 1e-9;
  SurfaceChart chart = TorusChart();
  const auto lift = chart.lift;
  chart.boundary = {CutOval};
  chart.min_boundary_vertices = 12;
  chart.allowed = [lift](const Vector2d& w, double edge_length) {
    return lift(w).x() < kCut - kClearance * edge_length;
  };
  const auto triangulate = chart.triangulate;
  chart.triangulate = [lift, triangulate](const std::vector<Vector2d>& points) {
    std::vector<Triangle> triangles = triangulate(points);
    const auto on_oval = [&](Index v) { return lift(points[v]).x() > kCut - kRounding; };
    std::erase_if(triangles,
                  [&](const Triangle& t) { return std::all_of(t.begin(), t.end(), on_oval); });
    return triangles;
  };
  chart.euler_characteristic = -1;
  return chart;
}

/// The half together with its mirror image in the plane x = kCut, where they share their vertices;
/// moved so that the mirror is x = 0.
PolygonSoup Double(const PolygonSoup& half) {
  constexpr double kRounding = 1e-9;
  std::vector<Vector3d> position;
  for (const Vector3d& p : half.position) position.emplace_back(p.x() - kCut, p.y(), p.z());
  std::vector<Index> image;
  const std::size_t vertices = position.size();
  for (std::size_t v = 0; v < vertices; ++v) {
    const Vector3d p = position[v];
    const bool shared = p.x() > -kRounding;
    image.push_back(static_cast<Index>(shared ? v : position.size()));
    if (!shared) position.emplace_back(-p.x(), p.y(), p.z());
  }
  std::vector<Triangle> triangles;
  for (std::size_t c = 0; c < half.corner.size(); c += 3) {
    triangles.push_back({half.corner[c], half.corner[c + 1], half.corner[c + 2]});
  }
  for (std::size_t f = 0, faces = triangles.size(); f < faces; ++f) {
    const auto [i, j, k] = triangles[f];
    triangles.push_back({image[i], image[k], image[j]});
  }
  return SoupOfTriangles(position, triangles);
}

}  // namespace

PolygonSoup Sphere(const GeneratorOptions& options) {
  return MeshChart(SphereChart([](const Vector3d&) { return 1.; }), options);
}

PolygonSoup Blob(const GeneratorOptions& options) {
  constexpr int kBumps = 12;
  struct Bump {
    Vector3d centre;
    double height, sharpness;
  };
  UniformRandom random(options.seed);
  std::vector<Bump> bumps;
  for (int i = 0; i < kBumps; ++i) {
    const double z = random(-1, 1), turn = random(0, 2 * kPi), r = std::sqrt(1 - z * z);
    const double height = random(-0.2, 0.3), sharpness = random(4, 12);
    bumps.push_back({{r * std::cos(turn), r * std::sin(turn), z}, height, sharpness});
  }
  const auto radius = [&](const Vector3d& direction) {
    double sum = 0;
    for (const Bump& bump : bumps) {
      sum += bump.height * std::exp(bump.sharpness * (bump.centre.dot(direction) - 1));
    }
    return std::exp(sum);
  };
  return MeshChart(SphereChart(radius), options);
}

PolygonSoup Torus(const GeneratorOptions& options) { return MeshChart(TorusChart(), options); }

PolygonSoup DoubleTorus(const GeneratorOptions& options) {
  GeneratorOptions half = options;
  half.triangles = (options.triangles + 1) / 2;
  return Double(MeshChart(CutTorusChart(), half));
}

}  // namespace cirque
