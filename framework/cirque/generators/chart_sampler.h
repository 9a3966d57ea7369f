#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"
#include "cirque/generators/surface_chart.h"

namespace cirque {

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
