// Geodesics between ideal points: on one circle they are its chords, whatever the scales.
#include "cirque/intrinsic/ideal_geodesic.h"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "cirque/intrinsic/ptolemy_complex.h"
#include "cirque/mesh/preflight.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// Points on a circle, triangulated from the first: the edge from the second to the last crosses all
/// others from the first.
struct FanOnCircle {
  explicit FanOnCircle(const std::vector<double>& angles) {
    std::vector<Eigen::Vector3d> points;
    for (const double a : angles) points.emplace_back(std::cos(a), std::sin(a), 0);
    std::vector<std::array<Index, 3>> triangles;
    for (Index i = 1; i + 1 < static_cast<Index>(points.size()); ++i) {
      triangles.push_back({0, i, i + 1});
    }
    surface = *SurfaceFromTriangles(points, triangles);
    const Triangulation& t = surface.triangulation;
    for (Index f = 0; f + 1 < t.num_faces(); ++f) {
      crossed.push_back(3 * f + 1);  // from the outer vertex i + 1 to the first
    }
    corner = 1;
  }

  Surface surface;
  Index corner;  ///< at the second point
  std::vector<Index> crossed;
};

/// Lengths with scales, which need not be triangles.
EdgeLengths Scaled(const Triangulation& t, const EdgeLengths& lengths, const Eigen::VectorXd& u) {
  EdgeLengths scaled = lengths;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    scaled.value[e] *= std::exp(0.5 * (u[t.Tail(h)] + u[t.Tip(h)]));
  }
  return scaled;
}

const std::vector<double>& Angles() {
  static const std::vector<double> kAngles = {0.2, 0.9, 1.1, 2.5, 3.7, 4.0, 5.9};
  return kAngles;
}

TEST(IdealGeodesic, OnACircleItIsTheChord) {
  const FanOnCircle fan(Angles());
  const Triangulation& t = fan.surface.triangulation;
  ASSERT_EQ(t.vertex[fan.corner], 1);
  const auto& p = fan.surface.position;
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(t.num_vertices);
  const PathPositions found =
      TraceIdealGeodesic(t, MeasureEdgeLengths(fan.surface), u, {fan.corner, fan.crossed});
  const Eigen::Vector2d from = p[1].head<2>(), to = p.back().head<2>();
  ASSERT_EQ(found.along_input.size(), Angles().size() - 3);
  for (std::size_t i = 0; i < fan.crossed.size(); ++i) {
    const Eigen::Vector2d tail = p[t.Tail(fan.crossed[i])].head<2>();
    const Eigen::Vector2d tip = p[t.Tip(fan.crossed[i])].head<2>();
    Eigen::Matrix2d system;
    system << to - from, tail - tip;
    const Eigen::Vector2d at = system.inverse() * (tail - from);
    EXPECT_NEAR(found.along_input[i], at[0], 1e-12);
    EXPECT_NEAR(found.along_crossed[i], at[1], 1e-12);
  }
}

TEST(IdealGeodesic, ScalesMoveItsPointsByAProjectiveMapOfEveryEdge) {
  const FanOnCircle fan(Angles());
  const Triangulation& t = fan.surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(fan.surface);
  Eigen::VectorXd u(t.num_vertices);
  for (Index v = 0; v < u.size(); ++v) u[v] = 2 * std::sin(3.0 * v + 1);
  const PathPositions plain = TraceIdealGeodesic(t, lengths, Eigen::VectorXd::Zero(t.num_vertices),
                                                 {fan.corner, fan.crossed});
  const PathPositions scaled =
      TraceIdealGeodesic(t, Scaled(t, lengths, u), u, {fan.corner, fan.crossed});
  for (std::size_t i = 0; i < fan.crossed.size(); ++i) {
    EXPECT_NEAR(scaled.along_input[i], plain.along_input[i], 1e-11);
    const double s = plain.along_crossed[i];
    const double tail = (1 - s) * std::exp(-u[t.Tail(fan.crossed[i])]);
    const double tip = s * std::exp(-u[t.Tip(fan.crossed[i])]);
    EXPECT_NEAR(scaled.along_crossed[i], tip / (tail + tip), 1e-11);
  }
}

TEST(IdealGeodesic, EitherTriangulationFindsTheSameCrossing) {
  // Of four points on no circle: the old diagonal over the new one, and the other way round.
  const Surface quad = *SurfaceFromTriangles(
      {{0, 0, 0}, {2, 0.3, 0}, {1.7, 1.9, 0}, {-0.2, 1.1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const Triangulation& t = quad.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(quad);
  const Index h = 1;  // from 2 to 0
  ASSERT_EQ(t.Tail(h), 2);
  PtolemyComplex complex(t, lengths.value.array().log());
  complex.Flip(h);
  const Triangulation flipped = complex.MakeTriangulation(4);
  Eigen::VectorXd u(4);
  u << 0.4, -1.1, 0.7, 0.2;
  EdgeLengths scaled{Eigen::VectorXd(flipped.num_edges())};
  for (Index e = 0; e < flipped.num_edges(); ++e) {
    scaled.value[e] = std::exp(complex.ScaledLogLength(flipped.edge_halfedge[e], u));
  }
  const auto trace = [h](const Triangulation& over, const EdgeLengths& with,
                         const Eigen::VectorXd& scale) {
    const std::vector<Index> crossed = {h};
    return TraceIdealGeodesic(over, with, scale, {h, crossed});
  };
  const PathPositions old_over_new = trace(flipped, scaled, u);
  const PathPositions new_over_old = trace(t, lengths, Eigen::VectorXd(-u));
  // The edge leaves the corner opposite h and crosses h; which way round either runs:
  const bool same_way = flipped.vertex[h] == t.Tail(h);
  const double along_old = same_way ? old_over_new.along_input[0] : 1 - old_over_new.along_input[0];
  EXPECT_NEAR(along_old, new_over_old.along_crossed[0], 1e-12);
  const bool runs_alike = t.vertex[h] == flipped.Tail(h);
  const double along_new =
      runs_alike ? new_over_old.along_input[0] : 1 - new_over_old.along_input[0];
  EXPECT_NEAR(along_new, old_over_new.along_crossed[0], 1e-12);
  EXPECT_GT(std::abs(along_old - 0.5), 0.01);
}

}  // namespace
}  // namespace cirque
