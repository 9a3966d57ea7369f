// The three ways to the quadratic program on real meshes.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "cirque/angles/angle_fit.h"
#include "cirque/angles/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

class RealMeshesSlow : public ::testing::TestWithParam<std::string> {};

TEST_P(RealMeshesSlow, DualInteriorPointAndAugmentedLagrangianAgreeInEveryAngle) {
  const auto mesh = ReadSharedSurface(GetParam());
  if (!mesh) GTEST_SKIP() << GetParam() << " is not there";
  const Triangulation& t = mesh->surface.triangulation;
  const AngleConstraints constraints(t, FreeBoundaryTargets(t));
  const CornerAngles reference = AnglesOf(mesh->surface);
  const auto fit_by = [&](const std::string& method, const OptionMap& options) {
    AngleFitResult fit;
    const Status status =
        FitAngles({constraints, reference.value, 1e-3}, *AngleObjectives().Find("quadratic"),
                  **MakeAngleSolver(method, options), {}, &fit);
    EXPECT_TRUE(status.ok()) << method << ": " << status.message();
    return fit.angles.value;
  };
  const Eigen::VectorXd dual = fit_by("newton", {});
  EXPECT_GT((dual - reference.value).lpNorm<Eigen::Infinity>(), 1e-3);
  for (const auto& [method, options] : std::map<std::string, OptionMap>{
           {"interior_point", {}}, {"ceres_augmented_lagrangian", {}}}) {
    EXPECT_LT((fit_by(method, options) - dual).lpNorm<Eigen::Infinity>(), 1e-6) << method;
  }
}

INSTANTIATE_TEST_SUITE_P(SharedDisks, RealMeshesSlow, ::testing::Values("gc-lego", "cid-aircraft"),
                         [](const auto& mesh) {
                           std::string name = mesh.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace cirque
