// Flips for the sake of the angle fit.
#include "cirque/pipeline/retriangulate.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

StatusOr<Parameterization> MapOf(const Surface& surface, int rounds,
                                 const std::string& objective = "entropy") {
  ParameterizeRequest request;
  request.options.retriangulate = rounds;
  request.options.angle_objective = objective;
  request.options.refine_map = "none";
  Parameterization result;
  const Status status = Parameterize(surface, request, SolveControl(), &result);
  return status.ok() ? StatusOr<Parameterization>(std::move(result)) : status;
}

class RetriangulateOf : public testing::TestWithParam<const char*> {};

/// Every round that is kept has a lower objective, and the angles are coherent where it is solved.
TEST_P(RetriangulateOf, LowersTheObjective) {
  const Surface surface = GeneratedSurface(GetParam(), 400);
  const auto plain = MapOf(surface, 0), flipped = MapOf(surface, 20);
  ASSERT_TRUE(plain.ok() && flipped.ok());
  EXPECT_FALSE(plain->certificate.retriangulation);
  ASSERT_TRUE(flipped->certificate.retriangulation);
  const RetriangulationSummary& summary = *flipped->certificate.retriangulation;
  EXPECT_LE(summary.active_edges_after, summary.active_edges_before);
  EXPECT_EQ(flipped->flat.intrinsic.flips.size(),
            plain->flat.intrinsic.flips.size() + summary.retriangulation_flips);
  const double before = plain->certificate.angle_fit->angle_primal;
  const double after = flipped->certificate.angle_fit->angle_primal;
  EXPECT_GT(before, 0);
  if (summary.retriangulation_flips > 0) {
    EXPECT_LT(after, before);
  } else {
    EXPECT_NEAR(after, before, 1e-6 * before);
  }
  EXPECT_LT(flipped->certificate.angle_fit->vertex_sum_residual, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, RetriangulateOf,
                         testing::Values("blob", "double_torus", "torus", "enneper_patch"));

/// A surface with a vertex of valence 3 in every triangle has no coherent angles; some of its
/// triangulations have.
TEST(Retriangulate, FindsAFeasibleTriangulation) {
  const Surface base = GeneratedSurface("blob", 100);
  PolygonSoup soup;
  soup.position = base.position;
  soup.first_corner = {0};
  for (Index f = 0; f < base.triangulation.num_faces(); ++f) {
    const Index* v = &base.triangulation.vertex[3 * f];
    const auto centre = static_cast<Index>(soup.position.size());
    soup.position.push_back((base.position[v[0]] + base.position[v[1]] + base.position[v[2]]) / 3);
    for (int k = 0; k < 3; ++k) {
      for (const Index corner : {v[k], v[(k + 1) % 3], centre}) soup.corner.push_back(corner);
      soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
    }
  }
  const Surface surface = SurfaceOf(soup);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(surface.triangulation, lengths);
  const auto targets = DefaultTargets(surface);
  ASSERT_TRUE(targets.ok());
  ParameterizeOptions options;
  options.retriangulate = 50;
  const SolveControl control;
  FlatSurface flat;
  std::vector<Index> same(surface.triangulation.num_edges());
  for (std::size_t e = 0; e < same.size(); ++e) same[e] = static_cast<Index>(e);
  flat.intrinsic = {surface.triangulation, lengths, {}, same};
  Certificate certificate;
  ASSERT_TRUE(Retriangulate({intrinsic, *targets, options, control}, &certificate, &flat).ok());
  EXPECT_GT(certificate.retriangulation->retriangulation_flips, 10);
  EXPECT_GT(flat.multipliers.size(), 0);
  ParameterizeRequest request;
  request.options = options;
  request.options.strict = true;
  request.options.triangulation = SolvedTriangulation::kInput;
  request.targets = targets.ok() ? std::optional(*targets) : std::nullopt;
  Parameterization raw, better;
  EXPECT_EQ(Parameterize(surface, request, control, &raw).code(), StatusCode::kInfeasible);
  EXPECT_TRUE(
      Parameterize(flat.intrinsic.triangulation, flat.intrinsic.lengths, request, control, &better)
          .ok());
}

}  // namespace
}  // namespace cirque
