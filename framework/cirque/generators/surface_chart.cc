#include "cirque/generators/surface_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/generators/chart_sampler.h"

namespace cirque {
namespace {

/// Steps towards the centroids: the smallest angle of 200,000 triangles is then above 19 degrees.
constexpr int kRelaxations = 12;

/// Moves every free point to the mean of its star's centroids, weighted by area / spacing^4, which
/// is the density whose centroidal patches are `spacing` wide (Gersho: density^(-1/4)).
void Relax(const SurfaceChart& chart, Index num_fixed, double edge_length,
           std::vector<Eigen::Vector2d>* points) {
  std::vector<Eigen::Vector3d> lifted(points->size());
  std::transform(points->begin(), points->end(), lifted.begin(), chart.lift);
  std::vector<Eigen::Vector3d> moment(points->size(), Eigen::Vector3d::Zero());
  std::vector<double> mass(points->size(), 0);
  for (const auto& [i, j, k] : chart.triangulate(*points)) {
    const Eigen::Vector3d centroid = (lifted[i] + lifted[j] + lifted[k]) / 3;
    const double area = (lifted[j] - lifted[i]).cross(lifted[k] - lifted[i]).norm() / 2;
    const double spacing = chart.spacing(centroid);
    const double weight = area / (spacing * spacing * spacing * spacing);
    for (const Index v : {i, j, k}) {
      moment[v] += weight * centroid;
      mass[v] += weight;
    }
  }
  for (std::size_t v = num_fixed; v < points->size(); ++v) {
    const Eigen::Vector2d moved = chart.flatten(moment[v] / mass[v]);
    if (chart.allowed(moved, edge_length)) (*points)[v] = moved;
  }
}

/// The edge length at which equilateral triangles of area sqrt(3)/4 edge^2 cover the mass.
double EdgeLength(double mass, Index triangles) {
  return std::sqrt(4 * mass / (std::sqrt(3.) * triangles));
}

}  // namespace

PolygonSoup MeshChart(const SurfaceChart& chart, const GeneratorOptions& options) {
  ChartSampler sampler(chart, options.seed);
  const double edge_length = EdgeLength(sampler.Mass(), options.triangles);
  std::vector<Eigen::Vector2d> points = sampler.Boundary(edge_length);
  const auto boundary = static_cast<Index>(points.size());
  points.insert(points.end(), chart.fixed.begin(), chart.fixed.end());
  const auto num_fixed = static_cast<Index>(points.size());

  // Triangles = 2 vertices - boundary vertices - 2 Euler characteristic.
  const Index vertices = (options.triangles + boundary + 2 * chart.euler_characteristic) / 2;
  const auto interior = sampler.Interior(std::max(vertices - num_fixed, Index{1}), edge_length);
  points.insert(points.end(), interior.begin(), interior.end());
  for (int i = 0; i < kRelaxations; ++i) Relax(chart, num_fixed, edge_length, &points);

  std::vector<Eigen::Vector3d> position(points.size());
  std::transform(points.begin(), points.end(), position.begin(), chart.lift);
  return SoupOfTriangles(position, chart.triangulate(points));
}

PolygonSoup SoupOfTriangles(const std::vector<Eigen::Vector3d>& position,
                            const std::vector<Triangle>& triangles) {
  PolygonSoup soup;
  std::vector<Index> number(position.size(), kNone);
  for (const Triangle& triangle : triangles) {
    for (const Index v : triangle) {
      if (number[v] == kNone) {
        number[v] = static_cast<Index>(soup.position.size());
        soup.position.push_back(position[v]);
      }
      soup.corner.push_back(number[v]);
    }
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  }
  return soup;
}

}  // namespace cirque
