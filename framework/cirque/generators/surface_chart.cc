#include "cirque/generators/surface_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

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

namespace {

constexpr int kCurveSteps = 4096;

/// Multipliers of Roberts' R2 sequence: 1/g and 1/g^2 with g^3 = g + 1.
constexpr double kSequenceA = 0.7548776662466927, kSequenceB = 0.5698402909980532;

/// Of how many mean distances the sequence's points are jittered, each way: enough to lose its
/// lattice, little enough to keep the points apart.
constexpr double kJitter = 0.5;

/// Of how much of a step a boundary vertex is jittered.
constexpr double kCurveJitter = 0.2;

/// Where a cumulated mass, rising linearly within each cell, reaches the share t of its total:
/// in cells.
double Quantile(const std::vector<double>& cumulated, double t) {
  const double target = t * cumulated.back();
  const auto above = std::upper_bound(cumulated.begin() + 1, cumulated.end() - 1, target);
  const double low = *(above - 1), mass = *above - low;
  const double within = mass > 0 ? std::clamp((target - low) / mass, 0., 1.) : 0.5;
  return static_cast<double>(above - 1 - cumulated.begin()) + within;
}

double Fraction(double x) { return x - std::floor(x); }

}  // namespace

ChartSampler::ChartSampler(const SurfaceChart& chart, unsigned seed)
    : chart_(chart), random_(seed) {
  Measure();
}

void ChartSampler::Measure() {
  rows_.assign(1, 0);
  std::vector<Eigen::Vector3d> last = LiftedLine(0);
  for (int i = 1; i <= kGrid; ++i) {
    const std::vector<Eigen::Vector3d> next = LiftedLine(i);
    std::vector<double>& row = cells_.emplace_back(1, 0.);
    for (int j = 0; j < kGrid; ++j) {
      const Eigen::Vector3d diagonal = next[j + 1] - last[j], other = last[j + 1] - next[j];
      const double spacing = chart_.spacing((last[j] + next[j] + last[j + 1] + next[j + 1]) / 4);
      row.push_back(row.back() + diagonal.cross(other).norm() / 2 / (spacing * spacing));
    }
    rows_.push_back(rows_.back() + row.back());
    last = next;
  }
}

std::vector<Eigen::Vector3d> ChartSampler::LiftedLine(int i) const {
  std::vector<Eigen::Vector3d> line;
  for (int j = 0; j <= kGrid; ++j) {
    line.push_back(chart_.lift(chart_.position(i / double{kGrid}, j / double{kGrid})));
  }
  return line;
}

Eigen::Vector2d ChartSampler::Transport(double s, double t) const {
  const double a = Quantile(rows_, s);
  const auto row = static_cast<std::size_t>(std::min(a, kGrid - 1.));
  return chart_.position(a / kGrid, Quantile(cells_[row], t) / kGrid);
}

std::vector<Eigen::Vector2d> ChartSampler::Boundary(double edge_length) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& curve : chart_.boundary) SampleCurve(curve, edge_length, &points);
  return points;
}

void ChartSampler::SampleCurve(const std::function<Eigen::Vector2d(double)>& curve,
                               double edge_length, std::vector<Eigen::Vector2d>* points) {
  std::vector<double> length = {0};
  Eigen::Vector3d last = chart_.lift(curve(0));
  for (int i = 1; i <= kCurveSteps; ++i) {
    const Eigen::Vector3d next = chart_.lift(curve(i / double{kCurveSteps}));
    length.push_back(length.back() + (next - last).norm() / chart_.spacing((next + last) / 2));
    last = next;
  }
  const Index count = std::max(chart_.min_boundary_vertices,
                               static_cast<Index>(std::lround(length.back() / edge_length)));
  for (Index i = 0; i < count; ++i) {
    const double step = i == 0 ? 0 : i + random_(-kCurveJitter, kCurveJitter);
    points->push_back(curve(Quantile(length, step / count) / kCurveSteps));
  }
}

std::vector<Eigen::Vector2d> ChartSampler::Interior(Index count, double edge_length) {
  std::vector<Eigen::Vector2d> points;
  const double jitter = kJitter / std::sqrt(count);
  const double start_a = random_(), start_b = random_();
  for (Index k = 0; static_cast<Index>(points.size()) < count; ++k) {
    const double s = Fraction(start_a + k * kSequenceA + random_(-jitter, jitter));
    const double t = Fraction(start_b + k * kSequenceB + random_(-jitter, jitter));
    const Eigen::Vector2d point = Transport(s, t);
    if (chart_.allowed(point, edge_length)) points.push_back(point);
  }
  return points;
}

}  // namespace cirque
