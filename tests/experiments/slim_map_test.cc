// Scalable locally injective mappings (studies slim), by which the framework's own descent of the
// symmetric Dirichlet energy is held against another method.
#include "experiments/studies/slim_map.h"

#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "cirque/domains/corner_places.h"
#include "cirque/domains/domain.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/convex_start.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

VertexUv ConvexStart(const Surface& surface) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const Triangulation& t = surface.triangulation;
  return PlacesOfVertices(t, *EmbedInDisk(MeasureSurface(t, lengths)));
}

TEST(SlimMap, EnergyOfKnownMaps) {
  const Surface fan = Fan(6, 0);
  VertexUv uv;
  for (const Eigen::Vector3d& p : fan.position) uv.emplace_back(p.x(), p.y());
  EXPECT_NEAR(SymmetricDirichletOf(fan, uv), 0, 1e-14);
  for (std::complex<double>& z : uv) z *= 7;  // the best scale of an image is not its own
  EXPECT_NEAR(SymmetricDirichletOf(fan, uv), 0, 1e-14);
  for (std::complex<double>& z : uv)
    z = {4 * z.real(), z.imag()};  // singular values 2 and 1/2 at the best scale
  EXPECT_NEAR(SymmetricDirichletOf(fan, uv), 4.25 - 2, 1e-13);
  for (std::complex<double>& z : uv) z = -std::conj(z);
  EXPECT_EQ(SymmetricDirichletOf(fan, uv), std::numeric_limits<double>::infinity());
}

TEST(SlimMap, UnfoldsWhatIsFlat) {
  const Surface flat = GeneratedSurface("flat_delaunay_patch", 200);
  VertexUv start = ConvexStart(flat);
  EXPECT_GT(SymmetricDirichletOf(flat, start), 1e-2);
  const SlimMap map = MinimizeBySlim(flat, std::move(start), 400, 1e-12);
  EXPECT_LT(SymmetricDirichletOf(flat, map.uv), 1e-8);
  EXPECT_GT(map.steps, 3);
}

TEST(SlimMap, AgreesWithTheFrameworksOwnDescent) {
  const Surface cap = GeneratedSurface("bumpy_terrain", 800);
  MapRequest request;
  request.options.refine_map = "symmetric_dirichlet";
  const StatusOr<SurfaceMap> own = MapSurface(cap, request);
  ASSERT_TRUE(own.ok()) << own.status().message();
  const SlimMap slim = MinimizeBySlim(cap, ConvexStart(cap), 400, 1e-10);
  const double least = SymmetricDirichletOf(cap, PlacesOfVertices(cap.triangulation, own->uv));
  EXPECT_GT(least, 1e-3);
  EXPECT_LE(least, SymmetricDirichletOf(cap, slim.uv) * (1 + 1e-6));
  EXPECT_NEAR(least, SymmetricDirichletOf(cap, slim.uv), 1e-3 * least);
}

}  // namespace
}  // namespace cirque
