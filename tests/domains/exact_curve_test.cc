// Exact maps onto curves: judged by the independent judge, their boundary on the curve.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/curves.h"

#include "tests/common/domain_maps.h"
#include "tests/common/exact_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

MapRequest ExactRequest(const std::string& curve) {
  MapRequest request = RequestFor("curve");
  request.shape.curve = curve;
  request.options.exact = true;
  return request;
}

Surface Stretched(const std::string& generator, Index triangles) {
  return Moved(GeneratedSurface(generator, triangles),
               [](const Eigen::Vector3d& x) { return Eigen::Vector3d(x.x(), x.y(), 3 * x.z()); });
}

double DistanceFrom(const ClosedCurve& curve, const Eigen::Vector2d& p) {
  double least = std::numeric_limits<double>::infinity();
  const auto& points = curve.points();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector2d side = points[(k + 1) % points.size()] - points[k];
    const double share = std::clamp((p - points[k]).dot(side) / side.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - points[k] - share * side).norm());
  }
  return least;
}

TEST(ExactCurve, HasItsBoundaryOnTheCurveByBothPatterns) {
  const Surface surface = Stretched("hemisphere", 600);
  const std::vector<Index> loop = BoundaryLoops(surface.triangulation).front();
  std::vector<bool> on_boundary(surface.triangulation.num_vertices, false);
  for (const Index h : loop) on_boundary[surface.triangulation.Tail(h)] = true;
  const StatusOr<ClosedCurve> ellipse = CurveOf("ellipse:ratio=1.8");
  ASSERT_TRUE(ellipse.ok()) << ellipse.status().message();
  for (const PatternKind pattern : {PatternKind::kCircle, PatternKind::kEquivalence}) {
    MapRequest request = ExactRequest("ellipse:ratio=1.8");
    request.options.pattern = pattern;
    const SurfaceMap map = MustMap(surface, request);
    ASSERT_TRUE(map.exact_map);
    EXPECT_GT(map.certificate.exact_map->exact_crossings, 20);
    ExpectExactMapIsAccepted(surface, map);
    const ExactMap& exact = *map.exact_map;
    for (std::size_t c = 0; c < exact.corner.size(); ++c) {
      const Index v = exact.corner[c];
      if (v >= surface.triangulation.num_vertices || !on_boundary[v]) continue;
      EXPECT_LT(DistanceFrom(*ellipse, exact.uv[exact.corner_uv[c]]), 1e-9);
    }
  }
}

// Chords are split for the solve; the pieces lie in the mesh's own faces.
TEST(ExactCurve, OfFacesBeyondChordsLiesInTheInputsFaces) {
  const Surface strip = Moved(FlatStrip(8, 5), [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x.x() + 1.1 * x.y(), x.y(), 0);
  });
  const SurfaceMap map = MustMap(strip, ExactRequest("ellipse"));
  ASSERT_TRUE(map.exact_map);
  ExpectExactMapIsAccepted(strip, map);
  for (const Index f : map.exact_map->face_of_input) EXPECT_LT(f, strip.triangulation.num_faces());
}

}  // namespace
}  // namespace cirque
