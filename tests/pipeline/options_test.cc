#include "cirque/pipeline/options.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

TEST(ParameterizeOptions, EveryFieldHasALineInTheTable) {
  // One field more does not compile here until it is bound, and counted in the table, which has all
  // but the last four.
  [[maybe_unused]] const auto& [pattern, triangulation, retriangulate, angle_objective,
                                angle_solver, radii_solver, layout, cones, cone_budget, cone_angles,
                                holonomy, integer_cells, boundary, refine_cones, refine_map, seams,
                                cut_cost, edge_costs, least_charts, epsilon, max_iterations,
                                solve_at, exact_limit, injective, strict, exact, own_objective,
                                own_cones, own_cut] = ParameterizeOptions();
  EXPECT_EQ(ParameterizeOptionTable().Names().size(), 25u);
  [[maybe_unused]] const auto& [centre, angle_zero, pole, normalization, corners, sides, curve,
                                pins, pin_weight, symmetric, axes, inversion] = DomainOptions();
  EXPECT_EQ(DomainOptionTable().Names().size(), 12u);
}

TEST(ParameterizeOptions, DefaultsAreValidAndEveryOptionIsExplained) {
  EXPECT_TRUE(CheckOptions({}).ok()) << CheckOptions({}).message();
  for (const auto& infos : {ParameterizeOptionTable().Infos(), DomainOptionTable().Infos()}) {
    for (const OptionInfo& option : infos) {
      EXPECT_GT(option.help.size(), 10u) << option.name;
      EXPECT_FALSE(option.group.empty()) << option.name;
    }
  }
}

/// Both ends of every number are allowed, what lies beyond is refused with them.
template <class T>
void ExpectBoundsHold(const OptionTable<T>& table) {
  for (const Option<T>& option : table.options()) {
    const OptionInfo& info = option.info();
    if (!IsNumeric(info.kind)) continue;
    T options;
    for (const double end : {info.bounds.lower, info.bounds.upper}) {
      const bool is_lower = end == info.bounds.lower;
      ASSERT_TRUE(std::isfinite(end)) << info.name;
      const auto text = [&](double value) {
        return info.kind == OptionKind::kInteger ? std::to_string(static_cast<long long>(value))
                                                 : ToText(value);
      };
      EXPECT_TRUE(option.Set(text(end), &options).ok()) << info.name;
      const double beyond = end + (is_lower ? -1 : 1);
      EXPECT_THAT(option.Set(text(beyond), &options).message(),
                  HasSubstr(info.name + " = '" + text(beyond) + "' is not "));
    }
  }
}

TEST(ParameterizeOptions, BoundsHold) {
  ExpectBoundsHold(ParameterizeOptionTable());
  ExpectBoundsHold(DomainOptionTable());
}

TEST(CheckOptions, TextsWithOptionsOfTheirOwnAreCheckedWithoutASurface) {
  const auto message = [](const OptionMap& texts) {
    ParameterizeOptions options;
    const Status set = ParameterizeOptionTable().Set(texts, &options);
    return set.ok() ? CheckOptions(options).message() : set.message();
  };
  EXPECT_EQ(message({{"cones", "greedy:target=0.1,norm=max"}}), "");
  EXPECT_EQ(message({{"cones", "moving:measure=angle,start=l1"}}), "");
  EXPECT_EQ(message({{"cone_angles", "ranges:width=0.3"}}), "");
  EXPECT_EQ(message({{"cut_cost", "visibility:directions=32"}}), "");
  EXPECT_THAT(message({{"cut_cost", "visibilty"}}),
              HasSubstr("cut_cost: unknown cut heuristic 'visibilty'; did you mean 'visibility'?"));
  EXPECT_THAT(message({{"cut_cost", "visibility:directions=0"}}), HasSubstr("directions = '0'"));
  EXPECT_THAT(message({{"cut_cost", "length:directions=8"}}), HasSubstr("unknown length option"));
  for (const char* refinement : {"mips:steps=5", "none", "auto", "auto:flag=1,rounds=2"}) {
    EXPECT_EQ(message({{"refine_map", refinement}}), "");
  }
  EXPECT_EQ(message({{"cones", "greedy"}, {"cone_budget", "3"}}), "");
  EXPECT_THAT(message({{"cones", "gredy"}}),
              HasSubstr("cones: unknown cone heuristic 'gredy'; did you mean 'greedy'?"));
  EXPECT_THAT(message({{"cones", "greedy:targt=1"}}), HasSubstr("did you mean 'target'?"));
  EXPECT_THAT(message({{"cones", "greedy:target=x"}}), HasSubstr("target = 'x' is not a number"));
  EXPECT_THAT(message({{"cones", "moving:start=moving"}}), HasSubstr("would never begin"));
  EXPECT_THAT(message({{"cones", "greedy:"}, {"cone_budget", "3"}}), "");
  EXPECT_THAT(message({{"cones", "greedy:target"}}), HasSubstr("'target' is no KEY=VALUE"));
  EXPECT_THAT(message({{"cone_budget", "3"}}), HasSubstr("a cone budget needs a heuristic"));
  EXPECT_THAT(message({{"cones", "none"}, {"cone_budget", "3"}}),
              HasSubstr("cone_budget: unknown none option 'cones'"));
  EXPECT_THAT(message({{"cone_angles", "pi/2:width=1"}}),
              HasSubstr("cone_angles: a width belongs to ranges, not to pi/2"));
  EXPECT_THAT(message({{"cone_angles", "pi/4"}}), HasSubstr("is not one of free, pi/2, pi/3"));
  EXPECT_THAT(message({{"cone_angles", "ranges:width=9"}}), HasSubstr("width = '9'"));
  EXPECT_THAT(message({{"refine_map", "mipz"}}), HasSubstr("did you mean 'mips'"));
  EXPECT_THAT(message({{"refine_map", "arp"}}), HasSubstr("did you mean 'arap'"));
  EXPECT_EQ(message({{"refine_map", "area:weight=0.3,steps=4"}}), "");
  EXPECT_THAT(message({{"refine_map", "area:weight=1.5"}}), HasSubstr("weight"));
  EXPECT_THAT(message({{"refine_map", "arap:weight=0.5"}}), HasSubstr("weight"));
  EXPECT_THAT(message({{"refine_map", "mips:decrease=2"}}),
              HasSubstr("decrease = '2' is not a number in [0, 1]"));
  EXPECT_THAT(message({{"layout", "direction"}}), HasSubstr("did you mean 'directions'?"));
}

TEST(CheckOptions, FieldsSetInCodeAreCheckedToo) {
  ParameterizeOptions options;
  options.epsilon = 2;
  EXPECT_EQ(CheckOptions(options).message(),
            "parameterize: epsilon = '2' is not a number in [1e-12, 1] rad");
  options = {};
  options.angle_solver = "newtn";
  EXPECT_THAT(CheckOptions(options).message(), HasSubstr("did you mean 'newton'?"));
  options = {};
  options.cones = "l1:lambda=-1";
  EXPECT_THAT(CheckOptions(options).message(), HasSubstr("lambda = '-1'"));
}

}  // namespace
}  // namespace cirque
