#include "cirque/cones/rotation_model.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_delaunay.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

std::vector<SignedCorners> LoopsOf(const Triangulation& t) {
  std::vector<SignedCorners> loops;
  for (const DualPath& loop : HandleLoops(t)) loops.push_back(CornersAlong(t, loop));
  return loops;
}

class RotationModelOf : public testing::TestWithParam<const char*> {
 protected:
  RotationModelOf()
      : surface_(GeneratedSurface(GetParam(), 900)),
        lengths_(MeasureEdgeLengths(surface_)),
        metric_(MakeIntrinsicDelaunay(surface_.triangulation, lengths_)),
        problem_(metric_.triangulation, metric_.lengths),
        model_(problem_, LoopsOf(metric_.triangulation)) {}

  const Triangulation& t() const { return metric_.triangulation; }

  /// Lengths e^{(u_i + u_j) / 2} times the metric's.
  EdgeLengths Scaled(const Eigen::VectorXd& u) const {
    EdgeLengths scaled = metric_.lengths;
    for (Index e = 0; e < t().num_edges(); ++e) {
      const Index h = t().edge_halfedge[e];
      scaled.value[e] *= std::exp(0.5 * (u[t().Tail(h)] + u[t().Tip(h)]));
    }
    return scaled;
  }

  Surface surface_;
  EdgeLengths lengths_;
  IntrinsicTriangulation metric_;
  ConeProblem problem_;
  RotationModel model_;
};

// Discrete conformal changes of the lengths turn loops as the change of the angle sums says, but
// for what is of second order: half the change, a quarter of the error.
TEST_P(RotationModelOf, AgreesWithChangesOfTheMetric) {
  ASSERT_GT(model_.size(), 0);
  const Eigen::VectorXd before = MeasureCornerAngles(t(), metric_.lengths).value;
  const auto error = [&](double size, int q, double* turned) {
    Eigen::VectorXd u(t().num_vertices);
    for (Index v = 0; v < u.size(); ++v) u[v] = size * std::sin(1.7 * v);
    const CornerAngles after = MeasureCornerAngles(t(), Scaled(u));
    const std::vector<double> sums = VertexAngleSums(t(), after);
    const std::vector<double> sums_before = VertexAngleSums(t(), {before});
    double predicted = 0;
    for (Index v = 0; v < u.size(); ++v) {
      predicted += model_.by_angle_sum()(q, v) * (sums[v] - sums_before[v]);
    }
    *turned =
        RotationAlong(model_.paths()[q], after.value) - RotationAlong(model_.paths()[q], before);
    return std::abs(predicted - *turned);
  };
  for (int q = 0; q < model_.size(); ++q) {
    double turned = 0;
    const double once = error(1e-4, q, &turned);
    EXPECT_GT(std::abs(turned), 1e-6);
    EXPECT_LT(once, 1e-2 * std::abs(turned));
    EXPECT_LT(error(5e-5, q, &turned), 0.3 * once + 1e-13);
  }
}

TEST_P(RotationModelOf, PredictsWhatIsWithTheMetricsOwnAngleSums) {
  const CornerAngles angles = MeasureCornerAngles(t(), metric_.lengths);
  const std::vector<double> sums = VertexAngleSums(t(), angles);
  std::vector<Cone> cones;
  for (Index v = 0; v < t().num_vertices; ++v) cones.push_back({v, sums[v], sums[v]});
  const Eigen::VectorXd predicted = model_.Predict(cones);
  for (int q = 0; q < model_.size(); ++q) {
    EXPECT_NEAR(predicted[q], RotationAlong(model_.paths()[q], angles.value), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, RotationModelOf, testing::Values("torus", "double_torus"));

}  // namespace
}  // namespace cirque
