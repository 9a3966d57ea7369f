#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

double Area(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  double area = 0;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const Eigen::Vector3d a = surface.position[t.vertex[h]];
    area +=
        0.5 *
        (surface.position[t.vertex[h + 1]] - a).cross(surface.position[t.vertex[h + 2]] - a).norm();
  }
  return area;
}

TEST(MidpointSubdivision, KeepsTopologyAreaAndAngles) {
  for (const char* name : {"bumpy_terrain", "torus", "annulus"}) {
    SCOPED_TRACE(name);
    const PolygonSoup coarse = *GenerateMesh(name, {200, 1});
    const Surface before = SurfaceOf(coarse), after = SurfaceOf(MidpointSubdivision(coarse, 2));
    EXPECT_EQ(after.triangulation.num_faces(), 16 * before.triangulation.num_faces());
    EXPECT_EQ(EulerCharacteristic(after.triangulation), EulerCharacteristic(before.triangulation));
    EXPECT_EQ(BoundaryLoops(after.triangulation).size(),
              BoundaryLoops(before.triangulation).size());
    EXPECT_NEAR(Area(after) / Area(before), 1, 1e-13);
    const Eigen::VectorXd coarse_angles = AnglesOf(before).value, angles = AnglesOf(after).value;
    for (Index f = 0; f < after.triangulation.num_faces(); ++f) {
      for (Index k = 0; k < 3; ++k) {
        EXPECT_NEAR(angles[3 * f + k], coarse_angles[3 * (f / 16) + k], 1e-9);
      }
    }
  }
}

TEST(MidpointSubdivision, OldVerticesStayAndNewOnesLieBetween) {
  const PolygonSoup coarse = *GenerateMesh("flat_delaunay_patch", {50, 1});
  const PolygonSoup fine = MidpointSubdivision(coarse, 1);
  for (std::size_t v = 0; v < coarse.position.size(); ++v) {
    EXPECT_EQ(fine.position[v], coarse.position[v]);
  }
  EXPECT_EQ(fine.position[fine.corner[1]],
            0.5 * (coarse.position[coarse.corner[0]] + coarse.position[coarse.corner[1]]));
  EXPECT_EQ(MidpointSubdivision(coarse, 0).corner, coarse.corner);
}

}  // namespace
}  // namespace cirque
