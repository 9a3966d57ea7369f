#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/schema.h"
#include "tests/common/paths.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A config that is right in everything but what `mesh` and `rest` change. Lines: 1 question,
/// 2 meshes, 3 the mesh, 4 methods, 5 the method, 6 the rest.
std::string Config(const std::string& mesh, const std::string& method,
                   const std::string& rest = "") {
  return "question: why\nmeshes:\n  - " + mesh + "\nmethods:\n  - " + method + "\n" + rest;
}

constexpr char kMesh[] = "generator: bumpy_terrain";
constexpr char kMethod[] = "name: a";

struct BadConfig {
  std::string name, text, first_line;  ///< the message's first line, after the file's name
};

std::ostream& operator<<(std::ostream& stream, const BadConfig& bad) { return stream << bad.name; }

const std::vector<BadConfig>& BadConfigs() {
  static const std::vector<BadConfig> configs = {
      {"Empty", "", ":1:1: the file is empty; see --help_config"},
      {"OnlyComment", "# nothing\n", ":1:1: the file is empty; see --help_config"},
      {"NotAMap", "- a\n", ":1:1: the file must be 'key: value' lines"},
      {"TwoDocuments", "a: 1\n---\nb: 2\n",
       ":2:1: the file must hold one YAML document, without '---'"},
      {"Syntax", "question: a: b\n",
       ":1:12: not valid YAML: illegal map value; a value with ': ' in it stands in quotes"},
      {"Tab", "question: a\nmeshes:\n\t- {generator: sphere}\n",
       ":3:2: not valid YAML: illegal block entry; the line begins with a tab, and YAML indents by "
       "spaces"},
      {"Unclosed", "question: [1\nmeshes: 2\n",
       ":2:7: not valid YAML: end of sequence flow not found"},
      {"DeepNesting", std::string(100000, '['),
       ":1:11: lists and maps nested deeper than 20 levels"},
      {"UnknownAnchor", "question: *nope\n",
       ":1:11: not valid YAML: the referenced anchor is not defined"},
      {"MisspeltTopKey", Config(kMesh, kMethod, "repeat: 2\n"),
       ":6:1: unknown key 'repeat'; did you mean 'repeats'? Known: question, meshes, methods, "
       "peer, "
       "repeats, seeds, include, exclude, time_limit, memory_limit, keep_maps, reference, "
       "against_refined, "
       "measures, output, figures"},
      {"MergeKey", Config(kMesh, kMethod, "<<: {repeats: 2}\n"),
       ":6:1: unknown key '<<'. Known: question, meshes, methods, peer, repeats, seeds, include, "
       "exclude, time_limit, memory_limit, keep_maps, reference, against_refined, measures, "
       "output, figures"},
      {"MisspeltMethodKey", Config(kMesh, "{name: a, epsilom: 1}"),
       ":5:15: unknown key of 'methods' 'epsilom'; did you mean 'epsilon'? Known: name, "
       "domain, exact, energy, energy_solver, energy_start, pattern, triangulation, retriangulate, "
       "angle_objective, angle_solver, "
       "radii_solver, layout, cones, cone_budget, cone_angles, holonomy, integer_cells, boundary, "
       "refine_cones, "
       "injective, refine_map, seams, cut_cost, edge_costs, least_charts, epsilon, solve_at, "
       "exact_limit, max_iterations"},
      {"Duplicate", Config(kMesh, kMethod, "repeats: 1\nrepeats: 2\n"),
       ":7:1: 'repeats' is given twice (first on line 6): remove one"},
      {"DuplicateInEntry", Config("{generator: bumpy_terrain, seed: 1, seed: 2}", kMethod),
       ":3:41: 'seed' is given twice (first on line 3): remove one"},
      {"Missing", "meshes:\n  - generator: bumpy_terrain\nmethods:\n  - name: a\n",
       ":1:1: the key 'question' is missing: what the experiment asks, in one sentence"},
      {"NoValue", Config(kMesh, kMethod, "repeats:\n"),
       ":6:1: 'repeats' has no value; expected a whole number from 1 to 1000"},
      {"NotANumber", Config(kMesh, "{name: a, epsilon: small}"),
       ":5:24: 'epsilon' must be a number from 1e-12 to 1, not 'small'"},
      {"NotFinite", Config(kMesh, "{name: a, epsilon: nan}"),
       ":5:24: 'epsilon' must be a number from 1e-12 to 1, not 'nan'"},
      {"OutOfRange", Config(kMesh, "{name: a, epsilon: -1e-3}"),
       ":5:24: 'epsilon' must be a number from 1e-12 to 1, not '-1e-3'"},
      {"Fraction", Config(kMesh, kMethod, "repeats: 1.5\n"),
       ":6:10: 'repeats' must be a whole number from 1 to 1000, not '1.5'"},
      {"Overflow", Config(kMesh, kMethod, "repeats: 99999999999999999999\n"),
       ":6:10: 'repeats' must be a whole number from 1 to 1000, not '99999999999999999999'"},
      {"OctalLike", Config("{generator: bumpy_terrain, seed: 0x10}", kMethod),
       ":3:38: 'seed' must be a whole number from 0 to 4294967295, not '0x10'"},
      {"WrongInList", Config(kMesh, "{name: a, epsilon: [1e-3, 2]}"),
       ":5:31: 'epsilon' must be a number from 1e-12 to 1, not '2'"},
      {"ListWhereNone", Config(kMesh, kMethod, "repeats: [1, 2]\n"),
       ":6:10: 'repeats' must be a whole number from 1 to 1000"},
      {"MapInList", Config(kMesh, "{name: a, epsilon: [{b: 1}]}"),
       ":5:25: a value of 'epsilon' must be a number from 1e-12 to 1"},
      {"UnknownMeasure", Config(kMesh, kMethod, "measures: [log_scale_l2, overlap_are]\n"),
       ":6:26: unknown measures 'overlap_are'; did you mean 'overlap_area'?"},
      {"MeasureTwice", Config(kMesh, kMethod, "measures: [cut_length, cut_length]\n"),
       ":6:24: 'cut_length' is listed twice"},
      {"ExcludeNamesNothing", Config(kMesh, kMethod, "exclude: ['*/a', 'bump*/b']\n"),
       ":6:18: 'bump*/b' names no run; --dry_run lists them, e.g. 'bumpy_terrain/a'"},
      {"ExcludeEverything", Config(kMesh, kMethod, "exclude: '*/a'\n"),
       ":1:1: nothing to run: include and exclude leave no run"},
      {"KeepNothing", Config(kMesh, kMethod, "keep_maps: lion/a\n"),
       ":6:12: 'lion/a' names no run; --dry_run lists them, e.g. 'bumpy_terrain/a'"},
      {"NoTime", Config(kMesh, kMethod, "time_limit: 0\n"),
       ":6:13: 'time_limit' must be a number from 0.001 to 10000000, not '0'"},
      {"Yes", Config("{optional: yes, file: x}", kMethod),
       ":3:16: 'optional' must be true or false, not 'yes'"},
      {"EmptyList", "question: why\nmeshes: []\nmethods:\n  - name: a\n",
       ":2:1: 'meshes' is an empty list; give at least one"},
      {"EmptyMatrix", Config(kMesh, "{name: a, epsilon: []}"),
       ":5:15: 'epsilon' is an empty list; give at least one"},
      {"ScalarForList", "question: why\nmeshes: all\nmethods:\n  - name: a\n",
       ":2:9: 'meshes' must be a list of entries"},
      {"ScalarEntry", Config("bumpy_terrain", kMethod),
       ":3:5: an entry of 'meshes' must be 'key: value' lines"},
      {"NoSource", Config("name: a", kMethod),
       ":3:5: give exactly one of file, corpus, archive, generator (here: none)"},
      {"TwoSources", Config("{generator: bumpy_terrain, file: a.obj, optional: true}", kMethod),
       ":3:5: give exactly one of file, corpus, archive, generator (here: file, generator)"},
      {"UnknownGenerator", Config("generator: bumpy_terain", kMethod),
       ":3:16: unknown generator "
       "'bumpy_terain'; did you mean 'bumpy_terrain'?"},
      {"UnknownStrategy", Config(kMesh, "{name: a, radii_solver: newtn}"),
       ":5:29: radii_solver: unknown solver strategy 'newtn'; did you mean 'newton'?"},
      {"UnknownCones", Config(kMesh, "{name: a, cones: gredy}"),
       ":5:22: cones: unknown cone heuristic 'gredy'; did you mean 'greedy'?"},
      {"UnknownConeOption", Config(kMesh, "{name: a, cones: [none, 'greedy:targt=1']}"),
       ":5:29: cones: unknown greedy option 'targt'; did you mean 'target'?"},
      {"WideConeAngles", Config(kMesh, "{name: a, cone_angles: 'ranges:width=7'}"),
       ":5:28: cone_angles: cone_angles: width = '7' is not a number in [0, 6.28319] rad"},
      {"UnknownRefinement", Config(kMesh, "{name: a, refine_map: 'mips:step=5'}"),
       ":5:27: refine_map: unknown refine_map option 'step'; did you mean 'steps'?"},
      {"BudgetWithoutCones", Config(kMesh, "{name: a, cone_budget: 4}"),
       ":5:5: a cone budget needs a heuristic: name it as `cones`, one of none, given"},
      {"SeedOfAFile", Config("{file: a.obj, optional: true, seed: 3}", kMethod),
       ":3:35: 'seed' has a meaning only beside 'generator'"},
      {"NoMember", Config("archive: a.tgz", kMethod), ":3:5: 'archive' needs 'member' beside it"},
      {"MissingFile", Config("file: a.obj", kMethod),
       ":3:11: there is no file '/nowhere/a.obj'; put it there, or skip it with 'optional: true'"},
      {"EmptyPattern", Config("file: a*.obj", kMethod),
       ":3:11: no file matches '/nowhere/a*.obj'; put it there, or skip it with 'optional: true'"},
      {"AllSkipped", Config("{file: a.obj, optional: true}", kMethod),
       ":1:1: nothing to run: every mesh was skipped"},
      {"SubdivisionsNegative", Config("{generator: torus, subdivisions: -1}", kMethod),
       ":3:38: 'subdivisions' must be a whole number from 0 to 12, not '-1'"},
      {"SubdividedKnownMap",
       Config("{generator: hemisphere, boundary: known_map, subdivisions: [0, 1]}", kMethod),
       ":3:64: new vertices do not lie on the smooth surface"},
      {"UnknownDomain", Config(kMesh, "{name: a, domain: dick}"),
       ":5:23: unknown domain 'dick'; did you mean 'disk'? Known: plane, sphere, disk"},
      {"ForeignToTheDomain", Config(kMesh, "{name: a, domain: [plane, half_plane], cones: greedy}"),
       ":5:51: 'cones' has no meaning with domain 'half_plane', which takes refine_map, "
       "exact_limit, strict; give that domain an entry of its own"},
      {"ForeignToTheSphere", Config(kMesh, "{name: a, domain: sphere, cut_cost: length}"),
       ":5:41: 'cut_cost' has no meaning with domain 'sphere', which takes layout, "
       "refine_map"},
      {"NoCosts", Config(kMesh, "{name: a, edge_costs: costs.txt}"),
       ":5:27: edge_costs: there is no file '/nowhere/costs.txt'"},
      {"NoCones", Config(kMesh, "{name: a, cones: 'given:file=c.txt'}"),
       ":5:22: cones: there is no file '/nowhere/c.txt'"},
      {"NoAngles", Config(kMesh, "{name: a, boundary: 'given:file=c.txt'}"),
       ":5:25: boundary: there is no file '/nowhere/c.txt'"},
      {"SeedsOfFiles", Config("{file: a.obj, optional: true}", kMethod, "seeds: [1, 2]\n"),
       ":6:8: 'seeds' has a meaning for generated meshes only: nothing here is random"},
      {"SeedTwice", Config(kMesh, kMethod, "seeds: [1, 2, 1]\n"), ":6:15: '1' is listed twice"},
      {"SeedAndSeeds", Config("{generator: torus, seed: 3}", kMethod, "seeds: [1, 2]\n"),
       ":3:30: 'seeds' makes every generated mesh with its own seeds: remove one of"},
      {"SeedsByName", Config(kMesh, kMethod, "seeds: many\n"),
       ":6:8: 'seeds' must be a whole number from 0 to 4294967295, not 'many'"},
      {"FiguresNoList", Config(kMesh, kMethod, "figures: time\n"),
       ":6:10: 'figures' must be a list of entries"},
      {"FigureKind", Config(kMesh, kMethod, "figures:\n  - {kind: scater, x: cones, y: seams}\n"),
       ":7:12: unknown kind 'scater'; did you mean 'scatter'? Known: scatter, lines, histogram"},
      {"FigureAxis", Config(kMesh, kMethod, "figures:\n  - {x: triangels, y: seconds}\n"),
       ":7:9: unknown x 'triangels'; did you mean 'triangles'?"},
      {"FigureScale", Config(kMesh, kMethod, "figures:\n  - {x: cones, y: seams, scale: lg}\n"),
       ":7:33: unknown scale 'lg'; did you mean 'log'? Known: linear, log, log_x, log_y"},
      {"FigureBy", Config(kMesh, kMethod, "figures:\n  - {x: cones, y: seams, by: triangles}\n"),
       ":7:30: unknown by 'triangles'"},
      {"FigureWithoutX", Config(kMesh, kMethod, "figures:\n  - {y: seconds}\n"),
       ":7:5: the key 'x' is missing: what is shown from left to right"},
      {"FigureWithoutY", Config(kMesh, kMethod, "figures:\n  - {kind: lines, x: cones}\n"),
       ":7:5: 'lines' needs 'y'; only a histogram has none"},
      {"HistogramWithY",
       Config(kMesh, kMethod, "figures:\n  - {kind: histogram, x: cones, y: seams}\n"),
       ":7:36: a histogram counts runs: leave out 'y'"},
      {"FigureTwice",
       Config(kMesh, kMethod, "figures:\n  - {x: cones, y: seams}\n  - {y: seams, x: cones}\n"),
       ":8:5: this figure is listed twice"},
      {"SameMesh", Config("generator: bumpy_terrain\n  - generator: bumpy_terrain", kMethod),
       ":4:5: two meshes are named 'bumpy_terrain' (first on line 3); give one a 'name'"},
      {"SameMethod", Config(kMesh, "name: a\n  - name: a"),
       ":6:11: two methods are named 'a' (first on line 5)"},
      {"SameValue", Config(kMesh, "{name: a, epsilon: [0.1, 0.1]}"),
       ":1:1: two runs are called 'bumpy_terrain/a,epsilon=0.1'; is a value listed twice?"},
  };
  return configs;
}

class BadConfigTest : public ::testing::TestWithParam<BadConfig> {};

TEST_P(BadConfigTest, IsRefusedWithItsPlace) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("bad.yaml", GetParam().text);
  const StatusOr<ExperimentConfig> config = LoadConfig(path);
  ASSERT_FALSE(config.ok());
  EXPECT_EQ(config.status().code(), StatusCode::kInvalidInput);
  std::string message = config.status().message();
  for (std::size_t at; (at = message.find(folder.path() + "/")) != std::string::npos;) {
    message.replace(at, folder.path().size(), at == 0 ? "" : "/nowhere");
  }
  EXPECT_THAT(message, StartsWith("/bad.yaml" + GetParam().first_line));
}

INSTANTIATE_TEST_SUITE_P(Table, BadConfigTest, ::testing::ValuesIn(BadConfigs()),
                         [](const auto& row) { return row.param.name; });

TEST(RunExperimentConfig, ReportsAllProblemsInOrderWithSourceLineAndCaret) {
  const TemporaryFolder folder;
  const std::string path = folder.Write(
      "bad.yaml",
      "question: why\nrepeats: 0\nmeshes:\n  - file: a.obj\nmethods:\n\t\n  - nam: a\n");
  const StatusOr<ExperimentConfig> config = LoadConfig(path);
  ASSERT_FALSE(config.ok());
  EXPECT_EQ(
      config.status().message(),
      path + ":2:10: 'repeats' must be a whole number from 1 to 1000, not '0'\n" +
          "  repeats: 0\n           ^\n" +  //
          path + ":4:11: there is no file '" + folder.path() +
          "/a.obj'; put it there, or skip it with 'optional: true'\n" +
          "    - file: a.obj\n            ^\n" +  //
          path + ":7:5: unknown key of 'methods' 'nam'; did you mean 'name'? Known: name, " +
          "domain, exact, energy, energy_solver, energy_start, pattern, triangulation, "
          "retriangulate, angle_objective, angle_solver, "
          "radii_solver, layout, cones, cone_budget, cone_angles, holonomy, integer_cells, "
          "boundary, "
          "refine_cones, "
          "injective, refine_map, seams, cut_cost, edge_costs, least_charts, epsilon, solve_at, "
          "exact_limit, max_iterations, strict\n    "
          "- nam: a\n      "
          "^\n" +  //
          path +
          ":7:5: the key 'name' is missing: its name in tables\n" + "    - nam: a\n      ^\n");
}

TEST(RunExperimentConfig, CaretStandsUnderTheColumnAfterTabsAndUmlauts) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("bad.yaml", "{question: ü,\trepeets: 1}\n");
  const std::string message = LoadConfig(path).status().message();
  EXPECT_THAT(message, HasSubstr("\n  {question: ü,\trepeets: 1}\n               \t^\n"));
}

TEST(RunExperimentConfig, MissingFileAndFolderAreNamed) {
  EXPECT_EQ(LoadConfig("/nowhere/a.yaml").status().message(),
            "/nowhere/a.yaml: cannot open: No such file or directory");
  EXPECT_EQ(LoadConfig("/tmp").status().message(), "/tmp: is a folder, not a file");
}

std::vector<std::string> LabelsOf(const ExperimentConfig& config) {
  std::vector<std::string> labels;
  for (const PlannedRun& run : config.runs) labels.push_back(run.Label());
  return labels;
}

TEST(RunExperimentConfig, ListsMakeTheCrossProduct) {
  const TemporaryFolder folder;
  const std::string path = folder.Write(
      "a.yaml", Config("{generator: bumpy_terrain, triangles: [10, 20], seed: [1, 2, 3]}",
                       "{name: m, epsilon: [1e-3, 1e-2], max_iterations: [5, 50]}\n  - name: n",
                       "repeats: 2\n"));
  const StatusOr<ExperimentConfig> config = LoadConfig(path);
  ASSERT_TRUE(config.ok()) << config.status().message();
  EXPECT_EQ(config->runs.size(), 2u * 3 * (2 * 2 + 1) * 2);
  std::set<std::tuple<int, unsigned, double, int, int, std::string>> distinct;
  for (const PlannedRun& run : config->runs) {
    const ParameterizeOptions& options = run.method.options;
    distinct.emplace(run.mesh.generator_options.triangles, run.mesh.generator_options.seed,
                     options.epsilon, options.max_iterations, run.repeat, run.method.name);
  }
  EXPECT_EQ(distinct.size(), config->runs.size());
  EXPECT_EQ(LabelsOf(*config)[1], "bumpy_terrain-10-s1/m,epsilon=1e-3,max_iterations=5#2");
}

TEST(RunExperimentConfig, MeasuresGoToEveryRunAsOneOrAList) {
  const TemporaryFolder folder;
  const auto measures = [&](const std::string& rest) {
    const auto config = LoadConfig(folder.Write("a.yaml", Config(kMesh, kMethod, rest)));
    EXPECT_TRUE(config.ok()) << config.status().message();
    return config->runs.at(0).measures;
  };
  EXPECT_TRUE(measures("").empty());
  EXPECT_THAT(measures("measures: cut_length\n"), ElementsAre("cut_length"));
  EXPECT_THAT(measures("measures: [resolution, cut_length]\n"),
              ElementsAre("resolution", "cut_length"));
}

TEST(RunExperimentConfig, IncludeAndExcludeChooseTheRuns) {
  const TemporaryFolder folder;
  const auto labels = [&](const std::string& rest) {
    const auto config = LoadConfig(
        folder.Write("a.yaml", Config("{generator: bumpy_terrain, triangles: [10, 20, 30]}",
                                      "name: m\n  - name: n", "repeats: 2\n" + rest)));
    EXPECT_TRUE(config.ok()) << config.status().message();
    return LabelsOf(*config);
  };
  EXPECT_EQ(labels("").size(), 12u);
  EXPECT_THAT(labels("include: '*-20/*'\n"),
              ElementsAre("bumpy_terrain-20/m", "bumpy_terrain-20/m#2", "bumpy_terrain-20/n",
                          "bumpy_terrain-20/n#2"));
  EXPECT_THAT(labels("include: ['*-20/*', '*/n#2']\nexclude: ['*[23]0/m', '*-20/n']\n"),
              ElementsAre("bumpy_terrain-10/n#2", "bumpy_terrain-30/n#2"));
}

TEST(RunExperimentConfig, PatternsMayMeanMeshesThatAreNotHere) {
  const TemporaryFolder folder;
  const auto config = LoadConfig(
      folder.Write("a.yaml", Config("{file: no.obj, optional: true}\n  - " + std::string(kMesh),
                                    kMethod, "exclude: no/a\n")));
  ASSERT_TRUE(config.ok()) << config.status().message();
  EXPECT_THAT(LabelsOf(*config), ElementsAre("bumpy_terrain/a"));
}

TEST(RunExperimentConfig, LimitsAndKeptMapsGoToTheRuns) {
  const TemporaryFolder folder;
  const auto runs = [&](const std::string& rest) {
    const auto config = LoadConfig(
        folder.Write("a.yaml", Config(kMesh, std::string(kMethod) + "\n  - name: b", rest)));
    EXPECT_TRUE(config.ok()) << config.status().message();
    return config->runs;
  };
  const std::vector<PlannedRun> plain = runs("");
  EXPECT_EQ(plain[0].limits.seconds, 0);
  EXPECT_EQ(plain[0].limits.memory_mib, 0);
  EXPECT_FALSE(plain[0].keep_map);
  const std::vector<PlannedRun> limited =
      runs("time_limit: 2.5\nmemory_limit: 300\nkeep_maps: '*/b'\n");
  EXPECT_EQ(limited[1].limits.seconds, 2.5);
  EXPECT_EQ(limited[1].limits.memory_mib, 300);
  EXPECT_FALSE(limited[0].keep_map);
  EXPECT_TRUE(limited[1].keep_map);
  EXPECT_TRUE(runs("keep_maps: true\n")[0].keep_map);
}

TEST(RunExperimentConfig, TheReferencePageIsUpToDate) {
  std::ifstream page(ProjectPath("experiments/CONFIG.md"));
  const std::string text((std::istreambuf_iterator<char>(page)), {});
  EXPECT_EQ(text, ConfigMarkdown(ConfigSchema()))
      << "write it anew: run_experiment --help_config --markdown > experiments/CONFIG.md";
}

TEST(RunExperimentConfig, ASlipThatMakesMillionsOfRunsIsRefusedAtOnce) {
  const TemporaryFolder folder;
  std::string many = "[1";
  for (int i = 2; i <= 1000; ++i) many += "," + std::to_string(i);
  many += "]";
  const std::string path = folder.Write(
      "a.yaml",
      Config("{generator: bumpy_terrain, triangles: " + many + ", seed: " + many + "}", kMethod));
  EXPECT_THAT(LoadConfig(path).status().message(),
              HasSubstr(":3:5: with this entry 'meshes' makes 1000000 combinations; at most 100000 "
                        "are allowed"));
}

TEST(RunExperimentConfig, PatternsAndPathsStartAtTheFolderThatHoldsConfigs) {
  const TemporaryFolder folder;
  folder.Write("project/meshes/b.obj", "b");
  folder.Write("project/meshes/a.obj", "a");
  folder.Write("project/meshes/a.off", "a");
  const std::string path =
      folder.Write("project/configs/sub/x.yaml", Config("file: meshes/*.obj", kMethod));
  const StatusOr<ExperimentConfig> config = LoadConfig(path);
  ASSERT_TRUE(config.ok()) << config.status().message();
  EXPECT_THAT(LabelsOf(*config), ElementsAre("a/a", "b/a"));
  EXPECT_EQ(config->runs[0].mesh.file, folder.path() + "/project/meshes/a.obj");
  EXPECT_EQ(config->output, folder.path() + "/project/results/runs/x");
}

TEST(RunExperimentConfig, MeshesStandsForTheFolderOfTheEnvironmentOrForOneInTheProject) {
  const TemporaryFolder folder;
  folder.Write("project/meshes/a.obj", "a");
  folder.Write("elsewhere/b.obj", "b");
  const std::string path =
      folder.Write("project/configs/x.yaml", Config("file: $MESHES/*.obj", kMethod));
  const char* const before = std::getenv("CIRQUE_MESHES");
  const std::string kept = before ? before : "";
  unsetenv("CIRQUE_MESHES");
  const StatusOr<ExperimentConfig> own = LoadConfig(path);
  setenv("CIRQUE_MESHES", (folder.path() + "/elsewhere").c_str(), 1);
  const StatusOr<ExperimentConfig> other = LoadConfig(path);
  before ? setenv("CIRQUE_MESHES", kept.c_str(), 1) : unsetenv("CIRQUE_MESHES");
  ASSERT_TRUE(own.ok()) << own.status().message();
  EXPECT_EQ(own->runs[0].mesh.file, folder.path() + "/project/meshes/a.obj");
  ASSERT_TRUE(other.ok()) << other.status().message();
  EXPECT_EQ(other->runs[0].mesh.file, folder.path() + "/elsewhere/b.obj");
}

TEST(RunExperimentConfig, OptionalMeshesAreSkippedWithAWord) {
  const TemporaryFolder folder;
  const std::string path = folder.Write(
      "a.yaml", Config("generator: bumpy_terrain\n  - {file: no*.obj, optional: true}", kMethod));
  const StatusOr<ExperimentConfig> config = LoadConfig(path);
  ASSERT_TRUE(config.ok()) << config.status().message();
  EXPECT_THAT(LabelsOf(*config), ElementsAre("bumpy_terrain/a"));
  EXPECT_THAT(config->notes, ElementsAre(path + ":4:12: skipped, no file matches '" +
                                         folder.path() + "/no*.obj'"));
}

TEST(RunExperimentConfig, KeysLeftOutKeepTheDefaultsOfParameterizeOptions) {
  const TemporaryFolder folder;
  const StatusOr<ExperimentConfig> config =
      LoadConfig(folder.Write("a.yaml", Config(kMesh, "{name: a, max_iterations: 7}")));
  ASSERT_TRUE(config.ok()) << config.status().message();
  const ParameterizeOptions defaults, &options = config->runs[0].method.options;
  EXPECT_EQ(options.max_iterations, 7);
  EXPECT_EQ(options.epsilon, defaults.epsilon);
  EXPECT_EQ(options.angle_objective, defaults.angle_objective);
}

TEST(RunExperimentConfig, OldWordsWorkAndSayOnceWhatTheyAreCalledNow) {
  const TemporaryFolder folder;
  const std::string path = folder.Write(
      "a.yaml", Config(kMesh,
                       "{name: a, angle_fit: entropy, angle_strategy: dual}\n"
                       "  - {name: b, strategy: [newton, newton_cg], angle_fit: barrier}",
                       "figures:\n  - {x: triangles, y: seconds, by: strategy}\n"));
  const StatusOr<ExperimentConfig> config = LoadConfig(path);
  ASSERT_TRUE(config.ok()) << config.status().message();
  EXPECT_THAT(LabelsOf(*config),
              ElementsAre("bumpy_terrain/a", "bumpy_terrain/b,radii_solver=newton",
                          "bumpy_terrain/b,radii_solver=newton_cg"));
  EXPECT_EQ(config->runs[0].method.options.angle_objective, "entropy");
  EXPECT_EQ(config->runs[0].method.options.angle_solver, "dual");
  EXPECT_EQ(config->runs[2].method.options.radii_solver, "newton_cg");
  EXPECT_THAT(config->figures.dump(), HasSubstr("radii_solver"));
  EXPECT_THAT(config->renamed,
              ElementsAre(path + ":5:15: note: 'angle_fit' is called 'angle_objective' now",
                          path + ":5:35: note: 'angle_strategy' is called 'angle_solver' now",
                          path + ":6:15: note: 'strategy' is called 'radii_solver' now"));
}

TEST(RunExperimentConfig, AnOldWordBesideItsNewOneIsRefused) {
  const TemporaryFolder folder;
  const std::string path =
      folder.Write("a.yaml", Config(kMesh, "{name: a, strategy: newton, radii_solver: newton}"));
  EXPECT_THAT(LoadConfig(path).status().message(),
              HasSubstr(":5:33: 'radii_solver' is given twice (first on line 5): remove one"));
}

TEST(RunExperimentConfig, HelpExplainsEveryKeyAndItsExampleIsAValidConfig) {
  const std::string help = ConfigHelp(ConfigSchema());
  std::string words, line;  // the help without its line breaks
  std::istringstream stream(help);
  for (std::string word; stream >> word;) words += word + " ";
  for (const SchemaField& field : ConfigSchema()) {
    EXPECT_THAT(words, HasSubstr(field.Key()));
    EXPECT_THAT(words, HasSubstr(field.help));
  }
  for (std::istringstream lines(help); std::getline(lines, line);) {
    EXPECT_LE(line.size(), 100u) << line;
  }
  const TemporaryFolder folder;
  setenv("CIRQUE_MESHES", folder.path().c_str(), 1);  // where the optional meshes are not
  const std::string example = help.substr(help.find("Example:\n") + 9);
  const StatusOr<ExperimentConfig> config = LoadConfig(folder.Write("a.yaml", example));
  ASSERT_TRUE(config.ok()) << config.status().message();
  EXPECT_EQ(config->runs.size(), 4u);
}

TEST(RunExperimentConfig, EveryShippedConfigLoadsAndAsksAQuestion) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ProjectPath("configs"))) {
    if (entry.path().extension() != ".yaml") continue;
    SCOPED_TRACE(entry.path());
    const StatusOr<ExperimentConfig> config = LoadConfig(entry.path().string());
    ASSERT_TRUE(config.ok()) << config.status().message();
    EXPECT_EQ(config->question.back(), '?');
    EXPECT_FALSE(config->runs.empty());
    ++count;
  }
  EXPECT_GE(count, 1);
}

}  // namespace
}  // namespace cirque
