// The meshes of ConformalIdealDelaunay with the angle sums of its authors (M. Campen et al.,
// "Efficient and robust discrete conformal equivalence with boundary", ACM TOG 40(6), 2021).
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/equivalence/solve_log_scales.h"
#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/paths.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// One angle sum a vertex of the file.
ConeTargets GivenAngles(const std::string& mesh, const Surface& surface) {
  std::ifstream file(ProjectPath("../shared/meshes/" + mesh + "_Th_hat"));
  std::vector<double> of_file, sums;
  for (double sum; file >> sum;) of_file.push_back(sum);
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    sums.push_back(of_file.at(surface.soup_vertex.empty() ? v : surface.soup_vertex[v]));
  }
  return {sums, sums};
}

class GivenAnglesSlow : public ::testing::TestWithParam<const char*> {};

TEST_P(GivenAnglesSlow, AreReachedWithinFewSteps) {
  const auto read = ReadSharedSurface(GetParam());
  if (!read) GTEST_SKIP() << "no " << GetParam();
  const Triangulation& t = read->surface.triangulation;
  const ConeTargets targets = GivenAngles(GetParam(), read->surface);
  LogScalesResult result;
  const Status status =
      SolveLogScales(t, MeasureEdgeLengths(read->surface), targets, KeptEdges::kBoundary,
                     **MakeSolverStrategy("auto"), {}, &result);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_LE(result.residual, 1e-10);
  EXPECT_LE(result.solve.num_iterations(), 10);
  EXPECT_GT(result.angles.value.minCoeff(), 0);
  const std::vector<double> sums = VertexAngleSums(result.intrinsic.triangulation, result.angles);
  for (std::size_t v = 0; v < sums.size(); ++v) EXPECT_NEAR(sums[v], targets.lower[v], 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Meshes, GivenAnglesSlow,
                         ::testing::Values("cid-aircraft", "cid-fertility_tri", "cid-elephant"));

}  // namespace
}  // namespace cirque
