#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/mapped_faces.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(SphericalTest, ASphereCoversItselfOnceWithoutFlips) {
  const Surface sphere = GeneratedSurface("sphere", 500);
  EXPECT_TRUE(FlippedSphericalFaces(sphere.triangulation, sphere.position).empty());
  EXPECT_NEAR(SphericalDegree(sphere.triangulation, sphere.position), 1, 1e-12);
  std::vector<Eigen::Vector3d> mirrored = sphere.position;
  for (auto& x : mirrored) x.z() = -x.z();
  EXPECT_EQ(static_cast<Index>(FlippedSphericalFaces(sphere.triangulation, mirrored).size()),
            sphere.triangulation.num_faces());
  EXPECT_NEAR(SphericalDegree(sphere.triangulation, mirrored), -1, 1e-12);
}

TEST(SphericalTest, FlatTrianglesCountAsFlipped) {
  // An equator triangle contains the centre in its plane.
  Surface octahedron = RegularPolyhedron(8);
  const Index apex = octahedron.triangulation.vertex[0];
  octahedron.position[apex] = -(octahedron.position[octahedron.triangulation.vertex[1]] +
                                octahedron.position[octahedron.triangulation.vertex[2]])
                                   .normalized();
  const auto flipped = FlippedSphericalFaces(octahedron.triangulation, octahedron.position);
  EXPECT_EQ(std::count(flipped.begin(), flipped.end(), 0), 1);
}

TEST(SphericalTest, FacesInPlaneKeepTheirEdges) {
  const Surface blob = GeneratedSurface("blob", 300);
  const Triangulation& t = blob.triangulation;
  const EdgeLengths lengths = ChordLengths(t, blob.position);
  EXPECT_LT((lengths.value - MeasureEdgeLengths(blob).value).cwiseAbs().maxCoeff(), 1e-15);
  const CornerUv uv = FacesInPlane(MeasureSurface(t, lengths));
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const double side =
        (uv.value[Triangulation::Next(h)] - uv.value[Triangulation::Prev(h)]).norm();
    EXPECT_NEAR(side, lengths.value[t.edge[h]], 1e-14);
  }
  EXPECT_EQ(AngleDifferences(MeasureSurface(t, lengths).angles, MeasureSurface(t, lengths).angles)
                .maxCoeff(),
            0);
}

}  // namespace
}  // namespace cirque
