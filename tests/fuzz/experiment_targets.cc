// What run_experiment reads: configs, records, runs packed for a process of their own.
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <glog/logging.h>

#include "experiments/common/records.h"
#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/schema.h"
#include "experiments/run_experiment/results/columns.h"
#include "experiments/run_experiment/results/record.h"
#include "experiments/run_experiment/run/ready_run.h"
#include "tests/fuzz/fuzz_target.h"

namespace cirque::testing {
namespace {

constexpr char kConfig[] = R"(question: which?
meshes:
  - generator: sphere
    triangles: [20, 80]
    name: ball
  - {file: missing.obj, optional: true, subdivisions: 1}
methods:
  - name: plain
  - name: disk
    domain: disk
    epsilon: [1e-3, 0.01]
seeds: [1, 2]
repeats: 2
time_limit: 10
include: "ball*"
measures: [area_l2]
figures:
  - {x: triangles, y: seconds, scale: log}
)";

void RunConfig(std::string_view bytes) {
  const auto config = ParseConfig("/nowhere/a.yaml", std::string(bytes));
  if (!config.ok()) return CheckRefusal(config.status(), "/nowhere/a.yaml:");
  CHECK(!config->runs.empty() && config->runs.size() <= 100000u);
  for (const PlannedRun& run : config->runs) {
    const Status status = CheckOptions(run.method.options);
    CHECK(status.ok()) << status.message();
  }
}

/// A record a line, as results.jsonl has them: those that are whole make tables and go on.
void RunRecords(std::string_view bytes) {
  std::istringstream stream{std::string(bytes)};
  std::vector<Record> records;
  for (std::string line; std::getline(stream, line);) {
    std::optional<Record> record = ParseRecord(line);
    if (!record) continue;
    CHECK(ParseRecord(ToLine(*record)) == record);
    IsFinished(*record, PlannedRun());
    IsSettled(*record);
    records.push_back(*std::move(record));
  }
  if (records.empty()) return;
  CHECK(!ToCsv(records).empty());
  CHECK(!ToTable(records).empty());
}

ReadyRun SomeRun() {
  ReadyRun ready;
  ready.key = "0123456789abcdef";
  ready.run.mesh.name = "mesh";
  ready.run.method.name = "method";
  ready.run.measures = {"area_l2"};
  return ready;
}

void RunPackedRun(std::string_view bytes) {
  const StatusOr<ReadyRun> run = UnpackRun(std::string(bytes));
  if (!run.ok()) return CheckRefusal(run.status(), "not a packed run");
  const std::string packed = PackRun(*run);
  const StatusOr<ReadyRun> again = UnpackRun(packed);
  CHECK(again.ok()) << again.status().message();
  CHECK(PackRun(*again) == packed);
}

std::vector<std::string> ConfigWords() {
  std::vector<std::string> words = {
      "- ",     ": ",     "\n  ",        "[", "]",    "{",    "}",   ", ",  "&a ",
      "*a",     "---\n",  "...",         "#", "\"",   "'",    "|\n", ">\n", "? ",
      "!!str ", "<<: *a", "%YAML 1.2\n", "~", "null", "true", "1e9"};
  for (const SchemaField& field : ConfigSchema()) {
    words.push_back(field.Key() + ": ");
    words.insert(words.end(), field.choices.begin(), field.choices.end());
    words.insert(words.end(), field.former.begin(), field.former.end());
  }
  return words;
}

}  // namespace

std::vector<FuzzTarget> ExperimentTargets() {
  const std::string record =
      R"({"key":"ab","outcome":"ok","message":"","mesh":{"name":"m","triangles":4},"method":)"
      R"({"name":"a","epsilon":0.001},"repeat":0,"values":{"area_l2":0.5},"seconds":{"total":1},)"
      R"("measures":["area_l2"],"limits":{"seconds":3},"provenance":{"started":"2026"}})";
  const std::vector<std::string> json = {"\"key\"",
                                         "\"outcome\"",
                                         "\"ok\"",
                                         "\"values\"",
                                         "\"seconds\"",
                                         "\"measures\"",
                                         "\"limits\"",
                                         "\"time_limit\"",
                                         "\"map\"",
                                         "[",
                                         "]",
                                         "{",
                                         "}",
                                         ":",
                                         ",",
                                         "null",
                                         "1e999",
                                         "\\ud800",
                                         "\n",
                                         "~",
                                         "/"};
  const std::string folder = "experiments/run_experiment/";
  return {{"config", RunConfig, ConfigWords(), {kConfig}, {folder + "config/"}},
          {"records",
           RunRecords,
           json,
           {record + "\n" + record + "\n{\"key\": \"torn"},
           {folder + "results/record", folder + "results/columns", "experiments/common/records"}},
          {"packed_run",
           RunPackedRun,
           {"\x5f", "\x9f", "\xbf", "\xff", "\xfb"},
           {PackRun(SomeRun())},
           {folder + "run/ready_run_bytes"}}};
}

}  // namespace cirque::testing
