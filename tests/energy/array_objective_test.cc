#include "cirque/energy/array_objective.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/energy/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// An objective of the library asked by arrays.
class ByArrays final : public ArrayObjective {
 public:
  explicit ByArrays(std::shared_ptr<const AngleObjective> objective)
      : objective_(std::move(objective)) {}

  void Distances(std::span<const double> references, std::span<const double> x,
                 std::span<ScalarJet> jets) const override {
    ++calls_;
    for (std::size_t i = 0; i < jets.size(); ++i) {
      jets[i] = objective_->Distance(references[i], x[i]);
    }
  }

  int calls() const { return calls_; }

 private:
  std::shared_ptr<const AngleObjective> objective_;
  mutable int calls_ = 0;
};

std::vector<EdgeSlopes> EdgesOfAllKinds() {
  std::vector<EdgeSlopes> edges;
  for (const double ref_l : {0.02, 0.7, 1.5, 2.9}) {
    for (const double ref_r : {0.1, 1.0, 2.0}) {
      for (const double s_l : {-2.0, -0.3, 0.0, 0.4, 3.0}) {
        for (const double s_r : {-1.0, 0.0, 2.5}) {
          edges.push_back({ref_l, ref_r, s_l, s_r, false});
        }
        edges.push_back({ref_l, 0, s_l, 0, true});
      }
    }
  }
  return edges;
}

TEST(ArrayObjective, FindsTheConjugatesThatTheObjectiveItselfFinds) {
  for (const char* name : {"quadratic", "entropy"}) {
    const auto plain = *AngleObjectives().Find(name);
    const ByArrays arrays(plain);
    const std::vector<EdgeSlopes> edges = EdgesOfAllKinds();
    std::vector<EdgeConjugate> expected(edges.size()), found(edges.size());
    plain->Conjugates(edges, 0.01, expected);
    arrays.Conjugates(edges, 0.01, found);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      EXPECT_NEAR(found[e].alpha_l, expected[e].alpha_l, 1e-12) << name << " " << e;
      EXPECT_NEAR(found[e].alpha_r, expected[e].alpha_r, 1e-12) << name << " " << e;
      EXPECT_NEAR(found[e].value, expected[e].value, 1e-12) << name << " " << e;
      EXPECT_NEAR(found[e].h_ll, expected[e].h_ll, 1e-9) << name << " " << e;
      EXPECT_NEAR(found[e].h_lr, expected[e].h_lr, 1e-9) << name << " " << e;
      EXPECT_NEAR(found[e].h_rr, expected[e].h_rr, 1e-9) << name << " " << e;
    }
  }
}

TEST(ArrayObjective, ResidualsSquareToTheDistance) {
  const ByArrays arrays(*AngleObjectives().Find("entropy"));
  for (const double x : {0.3, 0.9, 1.0, 1.4}) {
    const ResidualJet residual = arrays.Residual(1, x);
    EXPECT_NEAR(0.5 * residual.value * residual.value, arrays.Distance(1, x).value, 1e-14);
    EXPECT_EQ(residual.value < 0, x < 1);
    EXPECT_GT(residual.slope, 0);
  }
}

TEST(ArrayObjective, AMapTakesAsManyCallsOfALargeSurfaceAsOfASmallOne) {
  std::vector<int> calls;
  for (const Index triangles : {200, 3200}) {
    const Surface surface = GeneratedSurface("bumpy_terrain", triangles);
    const auto own = std::make_shared<ByArrays>(*AngleObjectives().Find("quadratic"));
    MapRequest request, plain;
    request.options.refine_map = plain.options.refine_map = "none";
    plain.options.angle_objective = "quadratic";
    request.options.own_objective = own;
    const auto by_own = MapSurface(surface, request), by_name = MapSurface(surface, plain);
    ASSERT_TRUE(by_own.ok()) << by_own.status().message();
    double apart = 0;
    for (std::size_t h = 0; h < by_own->uv.value.size(); ++h) {
      apart = std::max(apart, (by_own->uv.value[h] - by_name->uv.value[h]).norm());
    }
    EXPECT_LT(apart, 1e-7);
    calls.push_back(own->calls());
  }
  EXPECT_LT(calls[1], 4 * calls[0]);  // sixteen times the corners
}

}  // namespace
}  // namespace cirque
