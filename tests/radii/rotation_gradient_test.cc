#include "cirque/radii/rotation_gradient.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cirque/angles/registry.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/radii/solve_log_radii.h"
#include "cirque/solver/solver_strategy.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

std::vector<SignedCorners> PathsOf(const Triangulation& t) {
  std::vector<SignedCorners> paths;
  for (const DualPath& path : HandleLoops(t)) paths.push_back(CornersAlong(t, path));
  for (const DualPath& path : BoundaryPaths(t)) paths.push_back(CornersAlong(t, path));
  return paths;
}

/// Coherent angles of an intrinsic Delaunay triangulation, nothing prescribed but flat vertices, or
/// a torus.
struct Fitted {
  explicit Fitted(const char* generator) : surface(GeneratedSurface(generator, 500)) {
    const EdgeLengths lengths = MeasureEdgeLengths(surface);
    metric = MakeIntrinsicDelaunay(surface.triangulation, lengths);
    const ConeTargets targets = FreeBoundaryTargets(metric.triangulation);
    const AngleConstraints constraints(metric.triangulation, targets);
    const Eigen::VectorXd reference =
        MeasureCornerAngles(metric.triangulation, metric.lengths).value;
    AngleFitResult fit;
    const Status status =
        FitAngles({constraints, reference, 1e-3}, *AngleObjectives().Find("entropy"),
                  **MakeAngleSolver("newton"), {}, &fit);
    EXPECT_TRUE(status.ok()) << status.message();
    angles = fit.angles;
  }

  LogRadii Radii(const CoherentAngles& of) const {
    LogRadiiResult result;
    const Status status =
        SolveLogRadii(metric.triangulation, of, **MakeSolverStrategy("newton"), {}, &result);
    EXPECT_TRUE(status.ok()) << status.message();
    return result.log_radii;
  }

  double Rotation(const CoherentAngles& of, const SignedCorners& path) const {
    return RotationAlong(path, FlatCornerAngles(metric.triangulation, of, Radii(of)).value);
  }

  Surface surface;
  IntrinsicTriangulation metric;
  CoherentAngles angles;
};

/// A change of the angles that keeps the sum of every triangle's, and nothing else.
Eigen::VectorXd RandomChange(Index num_halfedges) {
  std::mt19937 random(5);
  Eigen::VectorXd change(num_halfedges);
  for (double& x : change) x = static_cast<double>(random()) / 4294967296.0 - 0.5;
  for (Index h = 0; h < num_halfedges; h += 3) {
    change.segment<3>(h).array() -= change.segment<3>(h).mean();
  }
  return change;
}

class RotationGradient : public testing::TestWithParam<const char*> {};

TEST_P(RotationGradient, AgreesWithDifferences) {
  const Fitted fitted(GetParam());
  const Triangulation& t = fitted.metric.triangulation;
  const std::vector<SignedCorners> paths = PathsOf(t);
  ASSERT_FALSE(paths.empty());
  const auto gradients = RotationGradients(t, fitted.angles, fitted.Radii(fitted.angles), paths);
  ASSERT_TRUE(gradients.ok()) << gradients.status().message();
  const Eigen::VectorXd change = RandomChange(t.num_halfedges());
  const double step = 1e-5;
  for (std::size_t q = 0; q < paths.size(); ++q) {
    const auto rotation = [&](double length) {
      return fitted.Rotation({fitted.angles.value + length * change, 1e-3}, paths[q]);
    };
    const double expected = (rotation(step) - rotation(-step)) / (2 * step);
    EXPECT_GT(std::abs(expected), 1e-3);
    EXPECT_NEAR(gradients->col(static_cast<int>(q)).dot(change), expected,
                1e-6 * std::max(1.0, std::abs(expected)));
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, RotationGradient, testing::Values("torus", "catenoid"));

TEST(RotationGradients, OfNoPathsAreNone) {
  const Fitted fitted("spherical_cap");
  const auto gradients = RotationGradients(fitted.metric.triangulation, fitted.angles,
                                           fitted.Radii(fitted.angles), {});
  ASSERT_TRUE(gradients.ok());
  EXPECT_EQ(gradients->cols(), 0);
}

}  // namespace
}  // namespace cirque
