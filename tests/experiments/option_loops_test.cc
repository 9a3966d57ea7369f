// A new option is one line in one table: every line of the tables is found as a flag, a key of
// configs, in the help of both programs and in CONFIG.md, and does the same by each way.
#include <algorithm>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/pipeline/options.h"

#include "experiments/circle_patterns/flags.h"
#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/schema.h"
#include "tests/common/paths.h"
#include "tests/common/run_program.h"

namespace cirque {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// A value that is allowed and not the default.
std::string OtherValue(const OptionInfo& option) {
  for (const std::string& word : option.words) {
    if (word != option.default_text) return word;
  }
  if (option.kind == OptionKind::kBoolean) return option.default_text == "true" ? "false" : "true";
  if (IsNumeric(option.kind)) {
    return option.default_text == ToText(option.bounds.upper) ? ToText(option.bounds.lower) : "1";
  }
  if (option.name == "cones") return "greedy:target=0.5";
  if (option.name == "cone_angles") return "ranges:width=0.25";
  if (option.name == "refine_map") return "mips:steps=3";
  if (option.name == "cut_cost") return "visibility:directions=32";
  if (option.name == "angle_solver") return "dual:strategy=newton,max_seconds=5";
  if (option.name == "radii_solver") return "newton_cg:forcing=0.1";
  if (option.name == "boundary") return "least_area:share=0.5";
  return "some_text";
}

/// What else must be said with it.
OptionMap Company(const std::string& name) {
  if (name == "cone_budget") return {{"cones", "greedy"}};
  if (name == "integer_cells") return {{"holonomy", "pi/2"}};
  return {};
}

TEST(OptionLoops, EveryOptionOfTheTablesIsAFlagWithHelp) {
  CirclePatternsFlags flags;
  const std::string help = *HelpText(ProgramManual(), flags.line(), "all");
  for (const auto& infos : {ParameterizeOptionTable().Infos(), DomainOptionTable().Infos()}) {
    for (const OptionInfo& option : infos) {
      EXPECT_THAT(flags.Names(), Contains(option.name));
      EXPECT_THAT(help, HasSubstr("  --" + option.name));
    }
  }
}

TEST(OptionLoops, HelpIsGroupedAndWithinAHundredColumns) {
  const CirclePatternsFlags flags;
  const std::string help = *HelpText(ProgramManual(), flags.line(), "all");
  std::size_t before = 0;
  for (const std::string group :
       {"Files", "Shape", "Cones", "Cuts", "Solver", "Sphere", "Output", "Program"}) {
    const std::size_t first = help.find("\n" + group + ":\n");
    ASSERT_NE(first, std::string::npos) << group;
    EXPECT_GT(first, before) << group;
    EXPECT_EQ(help.find("\n" + group + ":\n", first + 1), std::string::npos) << group;
    before = first;
    EXPECT_THAT(*HelpText(ProgramManual(), flags.line(), group), ::testing::StartsWith(group));
  }
  const std::string first_screen = *HelpText(ProgramManual(), flags.line(), "");
  EXPECT_LE(std::count(first_screen.begin(), first_screen.end(), '\n'), 60);
  for (const std::string& text : {help, first_screen}) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  }
  EXPECT_THAT(HelpText(ProgramManual(), flags.line(), "cnes").status().message(),
              HasSubstr("did you mean 'cones'?"));
}

TEST(OptionLoops, EveryOptionOfTheMethodIsAKeyInHelpAndReference) {
  std::ifstream page(ProjectPath("experiments/CONFIG.md"));
  const std::string reference{std::istreambuf_iterator<char>(page), {}};
  std::vector<std::string> keys;
  for (const SchemaField* field : FieldsOf(ConfigSchema(), "methods")) keys.push_back(field->Key());
  for (const std::string& option : ParameterizeOptionTable().Names()) {
    EXPECT_THAT(keys, Contains(option));
    EXPECT_THAT(ConfigHelp(ConfigSchema()), HasSubstr("\n    " + option + "*:"));
    EXPECT_THAT(reference, HasSubstr("| `methods." + option + "` *"));
  }
}

TEST(OptionLoops, AFlagAndAKeySetTheSame) {
  const TemporaryFolder folder;
  const std::string costs = folder.Write("costs.txt", "");  // a config looks for it
  for (const OptionInfo& option : ParameterizeOptionTable().Infos()) {
    SCOPED_TRACE(option.name);
    OptionMap texts = Company(option.name);
    texts[option.name] = option.name == "edge_costs" ? costs : OtherValue(option);
    ParameterizeOptions wanted;
    ASSERT_TRUE(ParameterizeOptionTable().Set(texts, &wanted).ok());
    std::vector<std::string> arguments = {"-io", "in.obj", "-oo", "out.obj"};
    std::string entry = "{name: a";
    for (const auto& [name, text] : texts) {
      arguments.push_back("--" + name + "=" + text);
      entry += ", " + name + ": '" + text + "'";
    }
    CirclePatternsFlags flags;
    ASSERT_TRUE(flags.Parse(arguments).ok());
    const StatusOr<CirclePatternsJob> job = flags.Job();
    ASSERT_TRUE(job.ok()) << job.status().message();
    const StatusOr<ExperimentConfig> config = LoadConfig(folder.Write(
        "a.yaml", "question: why?\nmeshes: [{generator: torus}]\nmethods:\n  - " + entry + "}\n"));
    ASSERT_TRUE(config.ok()) << config.status().message();
    const OptionMap values = ParameterizeOptionTable().Values(wanted);
    EXPECT_EQ(ParameterizeOptionTable().Values(job->options), values);
    EXPECT_EQ(ParameterizeOptionTable().Values(config->runs[0].method.options), values);
    EXPECT_NE(values, ParameterizeOptionTable().Values({}));
  }
}

Status Parsed(const std::vector<std::string>& arguments) {
  CirclePatternsFlags flags;
  const Status status = flags.Parse(arguments);
  return status.ok() ? flags.Job().status() : status;
}

TEST(CirclePatternsFlags, EveryWayToWriteAFlag) {
  CirclePatternsFlags flags;
  ASSERT_TRUE(flags
                  .Parse({"-io", "a.obj", "--oo=b.obj", "-epsilon", "1e-4", "--flip_back", "-oc=c",
                          "--noinversion", "--fill_holes=yes", "-domain=plane"})
                  .ok());
  EXPECT_FALSE(flags.line().help_topic());
  CirclePatternsFlags plain;
  ASSERT_TRUE(plain
                  .Parse({"-io", "a.obj", "--oo=b.obj", "-epsilon", "1e-4", "--flip_back", "-oc=c",
                          "--fill_holes=yes"})
                  .ok());
  const StatusOr<CirclePatternsJob> job = plain.Job();
  ASSERT_TRUE(job.ok()) << job.status().message();
  EXPECT_EQ(job->input, "a.obj");
  EXPECT_EQ(job->output, "b.obj");
  EXPECT_EQ(job->options.epsilon, 1e-4);
  EXPECT_TRUE(job->flip_back);
  EXPECT_TRUE(job->mesh.fill_holes);
}

TEST(CirclePatternsFlags, AllCanStandInOneFile) {
  const TemporaryFolder folder;
  const std::string path =
      folder.Write("options.txt", "-io a.obj -oo b.obj\n--layout=least_squares\n");
  CirclePatternsFlags flags;
  ASSERT_TRUE(flags.Parse({path}).ok());
  EXPECT_EQ(flags.Job()->options.layout, LayoutMethod::kLeastSquares);
  const std::string wrong = folder.Write("wrong.txt", "-io a.obj -oo b.obj --layuot=x\n");
  EXPECT_EQ(CirclePatternsFlags().Parse({wrong}).message().rfind(wrong + ": unknown flag", 0), 0u);
  EXPECT_THAT(CirclePatternsFlags().Parse({folder.Path("none")}).message(),
              HasSubstr("cannot read this file of options"));
}

TEST(CirclePatternsFlags, MistakesAreToldBeforeAnyMeshIsRead) {
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"--layuot=directions"}, "unknown flag 'layuot'; did you mean 'layout'?"},
      {{"--layout=direction"},
       "--layout = 'direction' is not one of directions, least_squares; "
       "did you mean 'directions'?"},
      {{"--epsilon=2"}, "--epsilon = '2' is not a number in [1e-12, 1] rad"},
      {{"--max_iterations=0"}, "--max_iterations = '0' is not an integer in [1, 1e+06]"},
      {{"--no=maybe"}, "--no = 'maybe' is not true or false"},
      {{"--epsilon"}, "--epsilon needs a value"},
      {{"--cones=greedy:targt=1"}, "did you mean 'target'?"},
      {{"--cone_angles=ranges:width=x"}, "width = 'x' is not a number"},
      {{"--refine_map=mipz"}, "--refine_map: unknown map objective 'mipz'; did you mean 'mips'?"},
      {{"--angle_solver=interior_pont"}, "did you mean 'interior_point'?"},
      {{"--cone_budget=3"}, "a cone budget needs a heuristic"},
      {{"--domain=sphere", "--normalization=unifrom"}, "did you mean 'uniform'?"},
      {{"--threads=-1"}, "--threads = '-1' is not an integer in"},
      {{"stray"}, "unexpected argument 'stray'"}};
  for (const auto& [flags, message] : mistakes) {
    std::vector<std::string> arguments = {"-io", "/no/such/mesh.obj", "-oo", "out.obj"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const Status status = Parsed(arguments);
    EXPECT_EQ(status.code(), StatusCode::kInvalidInput) << flags[0];
    EXPECT_THAT(status.message(), HasSubstr(message));
  }
  EXPECT_TRUE(Parsed({"-io", "/no/such/mesh.obj", "-oo", "out.obj"}).ok());
}

StatusOr<ExperimentConfig> ConfigOf(const std::string& method) {
  const TemporaryFolder folder;
  return LoadConfig(folder.Write(
      "a.yaml", "question: why?\nmeshes: [{generator: torus}]\nmethods:\n  - " + method + "\n"));
}

TEST(OptionLoops, FlagsAndKeysLeaveTheSameToEveryDomain) {
  for (const std::string& domain : Domains().Names()) {
    for (const std::string& given : {std::string(), std::string("quadratic")}) {
      SCOPED_TRACE(domain + " " + given);
      std::vector<std::string> arguments = {"-io=a.obj", "-oo=b.obj", "--domain=" + domain};
      if (!given.empty()) arguments.push_back("--angle_objective=" + given);
      CirclePatternsFlags flags;
      ASSERT_TRUE(flags.Parse(arguments).ok());
      const auto config = ConfigOf("{name: a, domain: " + domain +
                                   (given.empty() ? "}" : ", angle_objective: " + given + "}"));
      ASSERT_TRUE(config.ok()) << config.status().message();
      EXPECT_EQ(ParameterizeOptionTable().Values(config->runs[0].method.options),
                ParameterizeOptionTable().Values(flags.Job()->options));
    }
  }
}

TEST(CirclePatternsFlags, OldNamesStandForTheNewOnes) {
  for (const auto& [old, now] : {std::pair{"angle_fit", "angle_objective"},
                                 {"angle_strategy", "angle_solver"},
                                 {"strategy", "radii_solver"}}) {
    ASSERT_NE(ParameterizeOptionTable().Find(old), nullptr);
    EXPECT_EQ(ParameterizeOptionTable().Find(old)->info().name, now);
  }
  CirclePatternsFlags flags;
  ASSERT_TRUE(flags.Parse({"-io=a", "-oo=b", "--strategy", "newton_cg"}).ok());
  EXPECT_EQ(flags.Job()->options.radii_solver, "newton_cg");
}

}  // namespace
}  // namespace cirque
