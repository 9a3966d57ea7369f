#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/run_experiment/results/columns.h"
#include "experiments/run_experiment/results/record.h"
#include "experiments/run_experiment/run/runner.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

ParameterizeOptions Coarse() {
  ParameterizeOptions options;
  options.epsilon = 1e-2;
  return options;
}

/// A pipeline that counts its calls and answers by the generator's seed.
class FakePipeline {
 public:
  RunFunction AsRunFunction() {
    return [this](const PlannedRun& run, const std::string& path) { return Answer(run, path); };
  }

  int calls = 0;
  std::map<unsigned, std::string> outcome;  ///< by seed; else "ok"

 private:
  RunResult Answer(const PlannedRun& run, const std::string& path) {
    EXPECT_EQ(path.empty(), !run.mesh.generator.empty());
    ++calls;
    const unsigned seed = run.mesh.generator_options.seed;
    RunResult result{7, 9, {}};
    result.certificate.outcome = outcome.contains(seed) ? outcome[seed] : "ok";
    if (result.certificate.outcome == "throw") throw std::runtime_error("out of luck");
    result.certificate.message = "say \"hi\", twice\nor more \xff";
    result.figures = {{"smallest_angle", 0.1 + 1.0 / (3 + seed)}, {"other", kNaN}};
    result.certificate.seconds.angles = 1e-300;
    return result;
  }
};

class RunExperimentTest : public ::testing::Test {
 protected:
  RunExperimentTest() {
    std::vector<MeshSpec> meshes;
    for (unsigned seed = 1; seed <= 3; ++seed) {
      MeshSpec mesh;
      mesh.generator = "fake";
      mesh.name = "fake-s" + std::to_string(seed);
      mesh.generator_options.seed = seed;
      meshes.push_back(mesh);
    }
    config_.name = "test";
    config_.output = folder_.path() + "/out";
    config_.runs = PlanRuns(meshes, {{"a", {}}, {"b", Coarse()}}, 1);
  }

  RunSummary Run(const RunnerOptions& options = {}) {
    const StatusOr<RunSummary> summary =
        RunExperiment(config_, config_.runs, options, fake_.AsRunFunction());
    EXPECT_TRUE(summary.ok()) << summary.status().message();
    return summary.ok() ? *summary : RunSummary();
  }

  std::vector<std::string> Lines() const {
    std::istringstream stream(folder_.Read("out/results.jsonl"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

  TemporaryFolder folder_;
  ExperimentConfig config_;
  FakePipeline fake_;
};

TEST_F(RunExperimentTest, FinishedRunsAreNotMadeAgain) {
  EXPECT_EQ(Run().ran, 6);
  const std::string before = folder_.Read("out/results.jsonl");
  const RunSummary again = Run();
  EXPECT_EQ(fake_.calls, 6);
  EXPECT_EQ(again.ran, 0);
  EXPECT_EQ(again.records.size(), 6u);
  EXPECT_EQ(folder_.Read("out/results.jsonl"), before);
}

TEST_F(RunExperimentTest, FreshMakesThemAgainAndTheLastRecordHolds) {
  Run();
  fake_.outcome[1] = "not_converged";
  RunnerOptions options;
  options.fresh = true;
  const RunSummary summary = Run(options);
  EXPECT_EQ(fake_.calls, 12);
  EXPECT_EQ(Lines().size(), 12u);
  EXPECT_EQ(summary.records.size(), 6u);
  EXPECT_FALSE(summary.AllSettled());
}

TEST_F(RunExperimentTest, AChangeOfTheRunOrTheMeshMakesANewRecord) {
  config_.runs.resize(1);
  config_.runs[0].mesh = {"m", folder_.Write("m.obj", "one"), "", "", "", {}};
  Run();
  config_.runs[0].method.options.epsilon *= 2;
  Run();
  EXPECT_EQ(fake_.calls, 2);
  folder_.Write("m.obj", "two");
  Run();
  EXPECT_EQ(fake_.calls, 3);
  folder_.Write("m.obj", "one");
  Run();
  EXPECT_EQ(fake_.calls, 3);
}

TEST_F(RunExperimentTest, ATornLastLineIsSkippedRunAgainAndSealed) {
  Run();
  const std::string whole = folder_.Read("out/results.jsonl");
  folder_.Write("out/results.jsonl", whole.substr(0, whole.size() - 40));
  const RunSummary summary = Run();
  EXPECT_EQ(fake_.calls, 7);
  EXPECT_EQ(summary.skipped_lines, 1);
  EXPECT_EQ(summary.records.size(), 6u);
  EXPECT_EQ(Run().ran, 0);
  int readable = 0;
  for (const std::string& line : Lines()) {
    readable += nlohmann::json::accept(line) ? 1 : 0;
  }
  EXPECT_EQ(readable, 6);
  EXPECT_EQ(Lines().size(), 7u);
}

TEST_F(RunExperimentTest, LinesThatAreNoRecordsAreCounted) {
  folder_.Write("out/results.jsonl", "{}\n[1]\n{\"key\":3,\"outcome\":\"ok\"}\n\nnull\n\x80\n");
  const RunSummary summary = Run();
  EXPECT_EQ(summary.skipped_lines, 5);
  EXPECT_EQ(summary.records.size(), 6u);
}

TEST_F(RunExperimentTest, LinesNestedDeeplyAreNoRecords) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  folder_.Write("out/results.jsonl", R"({"key":"a","outcome":"ok","values":)" + deep + "}\n");
  EXPECT_EQ(Run().skipped_lines, 1);
}

TEST_F(RunExperimentTest, RecordsOfAnythingElseThanWeWriteDoNoHarm) {
  const std::vector<Record> records = {
      {{"key", "b"}, {"outcome", "ok"}, {"values", 3}, {"measures", {1, "a~/b"}}, {"limits", 1}},
      {{"key", "c"}, {"outcome", "time_limit"}, {"limits", {{"seconds", "long"}}}}};
  PlannedRun run;
  run.limits.seconds = 3;
  EXPECT_TRUE(IsFinished(records[0], run));
  EXPECT_FALSE(IsFinished(records[1], run));  // at a limit that nobody knows: made again
  EXPECT_THAT(ToCsv(records), HasSubstr("time_limit"));
  EXPECT_THAT(ToTable(records), HasSubstr("time_limit"));
}

TEST_F(RunExperimentTest, StopsBeforeTheNextRunAndGoesOnFromThere) {
  RunnerOptions options;
  options.stop = [this] { return fake_.calls == 2; };
  const RunSummary stopped = Run(options);
  EXPECT_TRUE(stopped.stopped);
  EXPECT_FALSE(stopped.AllSettled());
  EXPECT_EQ(stopped.records.size(), 2u);
  EXPECT_EQ(Lines().size(), 2u);
  const RunSummary rest = Run();
  EXPECT_EQ(rest.ran, 4);
  EXPECT_TRUE(rest.AllSettled());
}

TEST_F(RunExperimentTest, OnlyMapsAndInfeasibilityCertificatesCountAsSettled) {
  for (const auto& [outcome, settled] : std::map<std::string, bool>{{"ok", true},
                                                                    {"infeasible", true},
                                                                    {"not_converged", false},
                                                                    {"unrepresentable", false},
                                                                    {"invalid_input", false},
                                                                    {"cancelled", false},
                                                                    {"throw", false}}) {
    SCOPED_TRACE(outcome);
    config_.output = folder_.path() + "/" + outcome;
    fake_.outcome[2] = outcome;
    EXPECT_EQ(Run().AllSettled(), settled);
  }
}

TEST_F(RunExperimentTest, AnExceptionIsARecordAndTheOthersAreStillRun) {
  fake_.outcome[1] = "throw";
  const RunSummary summary = Run();
  EXPECT_EQ(summary.ran, 6);
  EXPECT_EQ(summary.records[0]["outcome"], "exception");
  EXPECT_EQ(summary.records[0]["message"], "out of luck");
  EXPECT_EQ(summary.records[5]["outcome"], "ok");
}

TEST_F(RunExperimentTest, ACancelledRunIsMadeAgain) {
  fake_.outcome[3] = "cancelled";
  Run();
  fake_.outcome.clear();
  EXPECT_EQ(Run().ran, 2);
}

TEST_F(RunExperimentTest, ARunThatTheMachineFailedIsMadeAgain) {
  fake_.outcome[3] = "resource";
  EXPECT_FALSE(Run().AllSettled());
  fake_.outcome.clear();
  EXPECT_EQ(Run().ran, 2);
}

TEST_F(RunExperimentTest, TheLaterRecordHoldsThoughTheClockWasSetBack) {
  Run();
  // The same records as if the clock had been years ahead.
  std::string text = folder_.Read("out/results.jsonl");
  const std::string year = "\"started\":\"20";
  for (std::size_t at = text.find(year); at != std::string::npos; at = text.find(year, at + 1)) {
    text[at + year.size()] = '9';
  }
  folder_.Write("out/results.jsonl", text);
  RunnerOptions options;
  options.fresh = true;
  fake_.outcome[3] = "not_converged";
  EXPECT_FALSE(Run(options).AllSettled());
  EXPECT_FALSE(Run().AllSettled());  // read back from the file
}

TEST_F(RunExperimentTest, ARecordThatDoesNotFitOnTheDiskIsTakenBackWhole) {
  Run();
  const std::string before = folder_.Read("out/results.jsonl");
  rlimit limit = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small = {before.size() + 10, limit.rlim_max};
  signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  RunnerOptions options;
  options.fresh = true;
  const StatusOr<RunSummary> full =
      RunExperiment(config_, config_.runs, options, fake_.AsRunFunction());
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  signal(SIGXFSZ, SIG_DFL);
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.status().code(), StatusCode::kResource);
  EXPECT_EQ(folder_.Read("out/results.jsonl"), before);
  EXPECT_EQ(Run().ran, 0);
}

TEST_F(RunExperimentTest, InfeasibleRunsLeaveTheirCertificate) {
  fake_.outcome[2] = "infeasible";
  const RunSummary summary = Run();
  std::vector<std::string> keys, files;
  for (const Record& record : summary.records) {
    if (record["outcome"] == "infeasible")
      keys.push_back(record["key"].get<std::string>() + ".json");
  }
  for (const auto& entry : std::filesystem::directory_iterator(config_.output + "/certificates")) {
    files.push_back(entry.path().filename());
  }
  EXPECT_EQ(keys.size(), 2u);
  EXPECT_THAT(files, ::testing::UnorderedElementsAreArray(keys));
  EXPECT_TRUE(nlohmann::json::accept(folder_.Read("out/certificates/" + keys[0])));
}

TEST_F(RunExperimentTest, AMissingMeshStopsEverythingBeforeTheFirstRun) {
  config_.runs.back().mesh = {"gone", folder_.path() + "/gone.obj", "", "", "", {}};
  const StatusOr<RunSummary> summary =
      RunExperiment(config_, config_.runs, {}, fake_.AsRunFunction());
  EXPECT_EQ(summary.status().message(),
            folder_.path() + "/gone.obj: cannot open: No such file or directory");
  EXPECT_EQ(fake_.calls, 0);
  EXPECT_FALSE(std::filesystem::exists(config_.output));
}

TEST_F(RunExperimentTest, ARecordTellsWhereItComesFrom) {
  const Record record = Run().records[1];
  EXPECT_EQ(record["mesh"]["triangles"], 9);
  EXPECT_EQ(record["method"]["epsilon"], 1e-2);
  EXPECT_EQ(record["provenance"]["config"], "test");
  EXPECT_GE(record["seconds"]["total"].get<double>(), 0);
  EXPECT_TRUE(record["values"]["other"].is_null());
  for (const char* name : {"version", "commit", "code", "cpu", "cores", "libraries", "started"}) {
    EXPECT_TRUE(record["provenance"].contains(name)) << name;
  }
}

/// A CSV reader of its own: quotes, doubled quotes, line ends inside quotes.
std::vector<std::vector<std::string>> ParseCsv(const std::string& text) {
  std::vector<std::vector<std::string>> rows = {{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      rows.back().back() += text[i++];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      rows.back().push_back("");
    } else if (!quoted && c == '\n') {
      rows.push_back({""});
    } else {
      rows.back().back() += c;
    }
  }
  rows.pop_back();
  return rows;
}

TEST_F(RunExperimentTest, CsvAndJsonAgreeInEveryCell) {
  fake_.outcome[2] = "infeasible";
  Run();
  std::vector<Record> records;
  for (const std::string& line : Lines()) records.push_back(Record::parse(line));
  const auto rows = ParseCsv(folder_.Read("out/results.csv"));
  const std::vector<Column> columns = ColumnsFor(records);
  ASSERT_EQ(rows.size(), records.size() + 1);
  int numbers = 0, texts = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), columns.size());
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (i == 0) {
        EXPECT_EQ(rows[0][j], columns[j].name);
        continue;
      }
      const nlohmann::json::json_pointer pointer(columns[j].pointer);
      const Record& record = records[i - 1];
      if (!record.contains(pointer) || record.at(pointer).is_null()) {
        EXPECT_EQ(rows[i][j], "");
      } else if (record.at(pointer).is_string()) {
        EXPECT_EQ(rows[i][j], record.at(pointer).get<std::string>());
        ++texts;
      } else if (record.at(pointer).is_boolean()) {
        EXPECT_EQ(rows[i][j], record.at(pointer).get<bool>() ? "true" : "false");
      } else {
        EXPECT_EQ(std::stod(rows[i][j]), record.at(pointer).get<double>());
        ++numbers;
      }
    }
  }
  EXPECT_GT(numbers, 6 * 6);
  EXPECT_GT(texts, 6 * 6);
  EXPECT_THAT(rows[0], ::testing::IsSupersetOf({"other", "seconds_angles", "smallest_angle"}));
}

TEST_F(RunExperimentTest, TableShowsAlignedColumnsThatSomeRunFilled) {
  std::istringstream table(ToTable(Run().records));
  std::vector<std::string> lines;
  for (std::string line; std::getline(table, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 7u);
  for (const std::string& line : lines) EXPECT_EQ(line.size(), lines[0].size());
  EXPECT_THAT(lines[0], HasSubstr("min angle"));
  EXPECT_THAT(lines[0], ::testing::Not(HasSubstr("qc mean")));
  EXPECT_THAT(lines[1], HasSubstr("3.50e-01"));
}

TEST(RunExperimentMeasures, ChosenFiguresAreColumnsAndMakeAnotherRun) {
  MeshSpec mesh;
  mesh.name = mesh.generator = "torus";
  mesh.generator_options.triangles = 300;
  PlannedRun run = PlanRuns({mesh}, {{"a", {}}}, 1)[0];
  const auto key = [&] { return RunKey(run, "hash", MethodJson(run.method), "code"); };
  const std::string plain_key = key();
  const auto record = [&] {
    return MakeRecord("key", run, {}, ParameterizeRun(run, ""), nlohmann::json::object());
  };
  EXPECT_FALSE(record()["values"].contains("resolution_unit_area"));
  EXPECT_THAT(ToTable({record()}), ::testing::Not(HasSubstr("resolution_unit_area")));
  run.measures = {"resolution_unit_area", "quasi_conformal_mean"};
  const Record measured = record();
  EXPECT_GT(measured["values"]["resolution_unit_area"], 1);
  EXPECT_NE(key(), plain_key);
  const std::string table = ToTable({measured});
  EXPECT_THAT(table, HasSubstr("  resolution_unit_area\n"));
  EXPECT_THAT(table, ::testing::Not(HasSubstr("quasi_conformal_mean")));  // shown as "qc mean"
  EXPECT_THAT(ToCsv({measured}), HasSubstr(",resolution_unit_area,"));
}

TEST_F(RunExperimentTest, FilesOfAMethodCountByTheirContentWhereverTheyLie) {
  const std::vector<std::pair<std::string, std::string ParameterizeOptions::*>> kinds = {
      {"", &ParameterizeOptions::edge_costs},
      {"given:file=", &ParameterizeOptions::cones},
      {"given:file=", &ParameterizeOptions::boundary}};
  for (const auto& kind : kinds) {
    SCOPED_TRACE(kind.first);
    const auto content = [&](const std::string& path) {
      MethodSpec method = config_.runs[0].method;
      method.options.*kind.second = kind.first + path;
      return MethodByContent(method);
    };
    const std::string file = folder_.Write("a.txt", "1 2 0.5\n");
    const nlohmann::json first = *content(file);
    EXPECT_EQ(*content(folder_.Write("elsewhere/b.txt", "1 2 0.5\n")), first);
    folder_.Write("a.txt", "1 2 0.75\n");
    EXPECT_NE(*content(file), first);
    EXPECT_NE(first, MethodJson(config_.runs[0].method));
    const std::string missing = folder_.Path("missing.txt");
    EXPECT_EQ(content(missing).status().code(), StatusCode::kInvalidInput);
    EXPECT_THAT(content(missing).status().message(), HasSubstr(missing));
  }
}

TEST_F(RunExperimentTest, AChangedFileOfCostsMakesItsRunsAgain) {
  config_.runs.resize(1);
  config_.runs[0].method.options.edge_costs = folder_.Write("costs.txt", "1 2 0.5\n");
  EXPECT_EQ(Run().ran, 1);
  EXPECT_EQ(Run().ran, 0);
  folder_.Write("costs.txt", "1 2 3\n");
  EXPECT_EQ(Run().ran, 1);
}

TEST_F(RunExperimentTest, ProgressInAFileIsOneLineARun) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  RunnerOptions options;
  options.progress = file;
  config_.runs.resize(2);
  Run(options);
  std::rewind(file);
  std::string text(4096, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  EXPECT_THAT(text, ::testing::StartsWith("[1/2] fake-s1/a: ok, 0.00 s; say \"hi\", twice\n"
                                          "[2/2] fake-s1/b: ok, 0.00 s; say \"hi\", twice\n"));
}

TEST(RunExperimentPlannedRuns, OnlySelectsByName) {
  const std::vector<PlannedRun> runs =
      PlanRuns({{"lion", "l.off", "", "", "", {}}, {"tube", "t.off", "", "", "", {}}},
               {{"a", {}}, {"b", {}}}, 2);
  ASSERT_EQ(runs.size(), 8u);
  std::vector<std::string> labels;
  for (const PlannedRun& run : SelectRuns(runs, "tube/b")) labels.push_back(run.Label());
  EXPECT_THAT(labels, ElementsAre("tube/b", "tube/b#2"));
  EXPECT_TRUE(SelectRuns(runs, "cone").empty());
}

}  // namespace
}  // namespace cirque
