#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"
#include "cirque/generators/generators.h"
#include "cirque/generators/planar_delaunay.h"

namespace cirque {

/// Nearer than this share of an edge length no interior vertex should come to the boundary.
inline constexpr double kClearance = 0.3;

/// A smooth surface with a parameter plane, from which MeshChart makes an irregular triangle mesh.
/// Triangles are made in the plane, so a conformal chart gives the roundest ones.
struct SurfaceChart {
  /// The unit square onto the surface's part of the plane.
  std::function<Eigen::Vector2d(double, double)> position;
  /// The plane onto the surface.
  std::function<Eigen::Vector3d(const Eigen::Vector2d&)> lift;
  /// From a point near the surface back to the plane, for points on it the inverse of lift.
  std::function<Eigen::Vector2d(const Eigen::Vector3d&)> flatten;
  /// Whether an interior vertex may be here, on a mesh of this edge length: not so near the
  /// boundary that it would come to lie on it or beyond.
  std::function<bool(const Eigen::Vector2d&, double)> allowed;

  /// The pieces of the boundary, [0, 1) -> plane. Each begins with a vertex of the mesh.
  std::vector<std::function<Eigen::Vector2d(double)>> boundary;
  Index min_boundary_vertices = 1;  ///< per piece
  /// Further vertices that stay where they are.
  std::vector<Eigen::Vector2d> fixed;
  /// Edge length at a point of the surface, up to a factor.
  std::function<double(const Eigen::Vector3d&)> spacing = [](const Eigen::Vector3d&) { return 1.; };

  /// Triangulates points of the plane; the boundary's come first, the fixed ones next.
  std::function<std::vector<Triangle>(const std::vector<Eigen::Vector2d>&)> triangulate;
  Index euler_characteristic = 1;
};

/// A triangle mesh of the surface: boundary vertices at uneven steps along the boundary's pieces,
/// interior vertices first spread by a jittered low-discrepancy sequence (density 1 / spacing^2 on
/// the surface), then evened out by a few steps towards the centroids of their stars, at last
/// triangulated. Vertices are numbered as the faces first name them, so that neighbours have near
/// numbers, as in a scan; faces are in no special order. The number of triangles is what was asked
/// for or one less, unless boundary pieces with their least number of vertices leave no interior.
PolygonSoup MeshChart(const SurfaceChart& chart, const GeneratorOptions& options);

/// Triangles and their points as a soup; points are renumbered as the triangles first name them.
PolygonSoup SoupOfTriangles(const std::vector<Eigen::Vector3d>& position,
                            const std::vector<Triangle>& triangles);

/// Random numbers that are the same on every machine: the standard fixes the engine's output, but
/// not that of its distributions.
class UniformRandom {
 public:
  explicit UniformRandom(std::uint64_t seed) : engine_(seed) {}
  /// A multiple of 2^-53 in [0, 1).
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double operator()(double lower, double upper) { return lower + (upper - lower) * (*this)(); }

 private:
  std::mt19937_64 engine_;
};

/// Spreads points over a chart and its boundary with density 1 / spacing^2 on the surface.
class ChartSampler {
 public:
  ChartSampler(const SurfaceChart& chart, unsigned seed);

  /// Integral of 1 / spacing^2 over the surface.
  double Mass() const { return rows_.back(); }

  /// Vertices of the boundary, about `edge_length` * spacing apart, in the order of the pieces.
  std::vector<Eigen::Vector2d> Boundary(double edge_length);

  /// `count` interior points, allowed at this edge length.
  std::vector<Eigen::Vector2d> Interior(Index count, double edge_length);

 private:
  static constexpr int kGrid = 128;  ///< cells of the unit square, each way

  void Measure();
  std::vector<Eigen::Vector3d> LiftedLine(int i) const;
  void SampleCurve(const std::function<Eigen::Vector2d(double)>& curve, double edge_length,
                   std::vector<Eigen::Vector2d>* points);
  Eigen::Vector2d Transport(double s, double t) const;

  const SurfaceChart& chart_;
  UniformRandom random_;
  std::vector<double> rows_;                ///< kGrid + 1 cumulated masses of rows of cells
  std::vector<std::vector<double>> cells_;  ///< per row the kGrid + 1 cumulated masses of its cells
};

}  // namespace cirque
