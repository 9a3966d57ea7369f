// Subdivisions, domains, seeds, the reference and figures: what these keys of a config do.
#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/text.h"
#include "cirque/domains/domain.h"
#include "cirque/generators/generators.h"
#include "cirque/io/io.h"
#include "cirque/metrics/measure_map.h"
#include "cirque/pipeline/certificate.h"

#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/quantities.h"
#include "experiments/run_experiment/run/runner.h"
#include "tests/common/domain_maps.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class RunExperimentKeys : public ::testing::Test {
 protected:
  ExperimentConfig Load(const std::string& meshes, const std::string& methods,
                        const std::string& rest = "") {
    const auto config = LoadConfig(folder_.Write(
        "a.yaml", "question: why?\nmeshes:\n" + meshes + "methods:\n" + methods + rest));
    EXPECT_TRUE(config.ok()) << config.status().message();
    return config.ok() ? *config : ExperimentConfig();
  }

  std::vector<Record> Run(const ExperimentConfig& config) {
    const auto summary = RunExperiment(config, config.runs, {}, ParameterizeRun);
    EXPECT_TRUE(summary.ok()) << summary.status().message();
    return summary.ok() ? summary->records : std::vector<Record>();
  }

  TemporaryFolder folder_;
};

std::vector<std::string> MeshNames(const ExperimentConfig& config) {
  std::vector<std::string> names;
  for (const PlannedRun& run : config.runs) names.push_back(run.mesh.name);
  return names;
}

// A polygon is triangulated first: two squares are 4 triangles, split into 16 and 64.
TEST_F(RunExperimentKeys, SubdivisionsSplitEveryTriangleIntoFour) {
  folder_.Write("strip.obj",
                "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 1\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n");
  const ExperimentConfig config =
      Load("  - {file: strip.obj, subdivisions: [0, 1, 2]}\n", "  - name: a\n");
  EXPECT_THAT(MeshNames(config), ElementsAre("strip", "strip-sub1", "strip-sub2"));
  const std::vector<Record> records = Run(config);
  ASSERT_THAT(records, SizeIs(3));
  std::set<std::string> keys;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(records[i]["outcome"], "ok") << records[i]["message"];
    EXPECT_EQ(records[i]["mesh"]["triangles"], 4 * std::pow(4, i));
    EXPECT_EQ(records[i]["mesh"]["family"], "strip");
    keys.insert(records[i]["key"].get<std::string>());
  }
  EXPECT_THAT(keys, SizeIs(3));
}

TEST_F(RunExperimentKeys, MeshesAreMadeCoarserThenFiner) {
  const ExperimentConfig config = Load(
      "  - {generator: sphere, triangles: 2000, name: ball, decimate: 400, subdivisions: 1, "
      "subdivision: [midpoint, loop, sqrt3]}\n",
      "  - name: a\n");
  EXPECT_THAT(MeshNames(config),
              ElementsAre("ball-to400-sub1", "ball-to400-loop1", "ball-to400-sqrt31"));
  std::set<std::string> keys;
  for (const Record& record : Run(config)) {
    EXPECT_EQ(record["outcome"], "ok") << record["message"];
    const int times = record["mesh"]["name"] == "ball-to400-sqrt31" ? 3 : 4;
    EXPECT_NEAR(record["mesh"]["triangles"].get<int>(), 400 * times, 40);
    keys.insert(record["key"].get<std::string>());
  }
  EXPECT_THAT(keys, SizeIs(3));
}

TEST_F(RunExperimentKeys, SubdivisionDoesNotHideADefectOfTheMesh) {
  folder_.Write("bad.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n"
                "f 1 2 3\nf 1 2 4\nf 1 2 5\n");
  const std::vector<Record> records =
      Run(Load("  - {file: bad.obj, subdivisions: 1, repair: none}\n", "  - name: a\n"));
  EXPECT_EQ(records.at(0)["outcome"], "invalid_input");
}

TEST_F(RunExperimentKeys, SeveralComponentsAreRepairedAndMappedAsTheProgramDoes) {
  // Two unit squares whose common side has vertices twice, and a face of no area.
  folder_.Write("two.obj",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 1\nv 2 1 1\nv 1 1 0\n"
                "f 1 2 3 4\nf 5 6 7 8\nf 1 2 1\n");
  const ExperimentConfig config = Load("  - {file: two.obj, repair: [none, safe, weld]}\n",
                                       "  - name: a\n", "keep_maps: true\n");
  EXPECT_THAT(MeshNames(config), ElementsAre("two-none", "two", "two-weld"));
  const std::vector<Record> records = Run(config);
  ASSERT_THAT(records, SizeIs(3));
  EXPECT_EQ(records[0]["outcome"], "invalid_input");
  std::set<std::string> keys;
  for (const int i : {1, 2}) EXPECT_EQ(records[i]["outcome"], "ok") << records[i]["message"];
  for (const Record& record : records) keys.insert(record["key"].get<std::string>());
  EXPECT_THAT(keys, SizeIs(3));
  EXPECT_EQ(records[1]["values"]["components"], 2);
  EXPECT_FALSE(records[2]["values"].contains("components"));
  EXPECT_TRUE(records[1].contains("map"));
  const auto unknown = LoadConfig(folder_.Write(
      "b.yaml",
      "question: why?\nmeshes:\n  - {file: two.obj, repair: glue}\nmethods:\n  - name: a\n"));
  EXPECT_THAT(unknown.status().message(), HasSubstr("glue"));
}

// In the plane the map is the identity; Loop's surfaces go to a smooth one and their maps to its map, so
// that the distance from the next one falls.
TEST_F(RunExperimentKeys, AMapIsComparedWithThatOfTheRefinedSurface) {
  const std::string methods = "  - {name: a, refine_map: none}\n", rest = "against_refined: true\n";
  const std::string hills =
      "  - {generator: bumpy_terrain, triangles: 300, name: hills, subdivisions: [0, 1, 2], "
      "subdivision: loop}\n";
  for (const Record& record : Run(Load(hills, methods))) {
    EXPECT_FALSE(record["values"].contains("refined_map_rms_error"));
  }
  folder_.Write("flat.obj",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.4 0.5 0\n"
                "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  const std::string flat = "  - {file: flat.obj, subdivisions: [1, 2]}\n";
  for (const Record& record : Run(Load(flat, methods, rest))) {
    EXPECT_LT(record["values"]["refined_map_max_error"], 1e-9) << record.dump();
  }
  const std::vector<Record> records = Run(Load(hills, methods, rest));
  ASSERT_THAT(records, SizeIs(3));
  for (int i = 0; i < 3; ++i) {
    const auto& values = records[i]["values"];
    EXPECT_LE(values["refined_map_rms_error"], values["refined_map_max_error"]);
    if (i == 0) continue;
    const auto& coarser = records[i - 1]["values"];
    EXPECT_LT(values["refined_map_rms_error"],
              0.7 * coarser["refined_map_rms_error"].get<double>());
    EXPECT_NEAR(values["edge_length"], 0.5 * coarser["edge_length"].get<double>(), 0.01);
  }
  // What has a known map is compared with that; what has a seam with nothing.
  for (const std::string generator : {"hemisphere", "blob"}) {
    const std::string mesh = "  - {generator: " + generator + ", triangles: 300}\n";
    EXPECT_FALSE(Run(Load(mesh, methods, rest)).at(0)["values"].contains("refined_map_rms_error"));
  }
}

// The reference is timed beside the run and is no part of its time.
TEST_F(RunExperimentKeys, ReferenceIsTimedOnRequest) {
  const std::string mesh = "  - {generator: bumpy_terrain, triangles: 2000}\n";
  EXPECT_FALSE(Run(Load(mesh, "  - name: a\n")).at(0).contains("reference"));
  const Record record = Run(Load(mesh, "  - name: a\n", "reference: true\n")).at(0);
  EXPECT_GT(record["reference"]["cpu_seconds"], 0);
  EXPECT_GT(record["peak_memory_mib"], 1);
  EXPECT_GT(record["map_cpu_seconds"], 0);
  EXPECT_GT(record["cpu_seconds"], record["map_cpu_seconds"]);
  double stages = 0;
  for (const auto& [stage, seconds] : record["seconds"].items()) {
    if (stage != "total") stages += seconds.get<double>();
  }
  EXPECT_GE(record["seconds"]["total"], stages * 0.99);
}

std::string VerifyFlags(const std::string& domain) {
  return domain == "sphere" || domain == "disk" ? "--domain=" + domain : "--require_injective";
}

// verify_map, which shares no code with the solver, judges what the runner leaves behind.
TEST_F(RunExperimentKeys, EveryDomainRunsAndItsMapVerifies) {
  for (const std::string& domain : Domains().Names()) {
    SCOPED_TRACE(domain);
    const std::string generator = GeneratorFor(domain), input = folder_.Path(domain + ".obj");
    const std::vector<Record> records =
        Run(Load("  - {generator: " + generator + ", triangles: 400}\n",
                 "  - {name: a, domain: " + domain + "}\n",
                 "keep_maps: true\nmeasures: [overlap_area, angle_error_mean]\noutput: out\n"));
    ASSERT_EQ(records.at(0)["outcome"], "ok") << records[0]["message"];
    EXPECT_EQ(records[0]["method"]["domain"], domain);
    // The half-plane's pole belongs at infinity: the triangles there cannot keep their shapes.
    if (domain != "half_plane") {
      EXPECT_LT(records[0]["values"]["quasi_conformal_mean"], 1.5);
    }
    EXPECT_GT(records[0]["values"]["angle_error_mean"], 0);
    EXPECT_EQ(records[0]["values"].contains("overlap_area"), domain != "sphere");
    ASSERT_TRUE(WriteMesh(input, *GenerateMesh(generator, {400, 1})).ok());
    const ProgramResult verified =
        RunProgram("verify_map " + VerifyFlags(domain) + " " + input + " " +
                   folder_.Path("out/" + records[0]["map"].get<std::string>()));
    EXPECT_EQ(verified.exit_status, 0) << verified.output;
  }
}

TEST_F(RunExperimentKeys, ASurfaceThatADomainCannotTakeIsARecordThatSaysSo) {
  const std::vector<Record> records = Run(
      Load("  - {generator: torus, triangles: 200}\n", "  - {name: a, domain: [disk, sphere]}\n"));
  ASSERT_THAT(records, SizeIs(2));
  for (const Record& record : records) {
    EXPECT_EQ(record["outcome"], "invalid_input");
    EXPECT_NE(record["message"], "");
  }
}

TEST_F(RunExperimentKeys, SeedsMakeGeneratedMeshesAnewAndFilesOnce) {
  folder_.Write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const ExperimentConfig config =
      Load("  - generator: bumpy_terrain\n  - file: t.obj\n", "  - name: a\n", "seeds: [3, 7]\n");
  EXPECT_THAT(MeshNames(config), ElementsAre("bumpy_terrain-s3", "bumpy_terrain-s7", "t"));
  EXPECT_EQ(config.runs[1].mesh.generator_options.seed, 7u);
  ASSERT_THAT(config.notes, SizeIs(1));
  EXPECT_THAT(config.notes[0], HasSubstr("a.yaml:4:5: run without seeds: nothing of a mesh that is "
                                         "not generated is random"));
}

// Every name stands for a number or a text that some run has: the table cannot name what records
// no longer hold. Those of certificates are read from the certificate itself.
TEST_F(RunExperimentKeys, EveryQuantityOfFiguresIsInSomeRecord) {
  std::vector<Record> records =
      Run(Load("  - {generator: hemisphere, triangles: 200}\n",
               "  - {name: a, radii_solver: newton_cg, angle_solver: newton_cg}\n"
               "  - {name: b, energy: circle_pattern, energy_solver: newton_cg}\n",
               "reference: true\nmeasures: [" + Join(FigureNames()) + "]\n"));
  for (const Record& record : Run(Load("  - {generator: bumpy_terrain, triangles: 100}\n",
                                       "  - {name: a}\n", "against_refined: true\n"))) {
    records.push_back(record);
  }
  for (const Record& record : records) ASSERT_EQ(record["outcome"], "ok") << record.dump();
  const auto some_has = [&](const std::string& at, const auto& holds) {
    const nlohmann::json::json_pointer pointer(at);
    return std::any_of(records.begin(), records.end(), [&](const Record& record) {
      return record.contains(pointer) && holds(record.at(pointer));
    });
  };
  std::set<std::string> of_certificates;
  for (const CertificateField& field : CertificateFields()) of_certificates.insert(field.name);
  for (const Quantity& quantity : Quantities()) {
    if (of_certificates.contains(quantity.name)) continue;
    EXPECT_TRUE(some_has(quantity.pointer, [](const Record& at) { return at.is_number(); }))
        << quantity.name;
  }
  for (const Quantity& group : Groups()) {
    EXPECT_TRUE(some_has(group.pointer, [](const Record&) { return true; })) << group.name;
  }
}

TEST_F(RunExperimentKeys, FiguresAreWrittenForTheReport) {
  const ExperimentConfig config =
      Load("  - {generator: torus, triangles: [100, 400]}\n", "  - name: a\n",
           "output: out\nfigures:\n  - {x: triangles, y: seconds, by: mesh_family, scale: log}\n"
           "  - {kind: histogram, x: quasi_conformal_mean, title: <Angles>}\n");
  Run(config);
  const auto figures = nlohmann::json::parse(folder_.Read("out/figures.json"));
  ASSERT_THAT(figures, SizeIs(2));
  EXPECT_EQ(figures[0]["title"], "time [s] against triangles, by mesh");
  EXPECT_EQ(figures[0]["y"]["pointer"], "/seconds/total");
  const ProgramResult report = RunProgram("experiment_report " + folder_.Path("out"));
  EXPECT_EQ(report.exit_status, 0) << report.output;
  const std::string html = folder_.Read("out/report.html");
  EXPECT_LT(html.find("time [s] against triangles, by mesh"), html.find("&lt;Angles&gt;"));
  const auto points = nlohmann::json::parse(folder_.Read("out/report_figures.json"));
  ASSERT_THAT(points[0]["points"], SizeIs(2));
  EXPECT_EQ(points[0]["points"][0][0], "torus");
  EXPECT_EQ(points[0]["points"][1][1], 400);
  EXPECT_EQ(points[0]["x_scale"], "log");
}

}  // namespace
}  // namespace cirque
