#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "experiments/run_experiment/results/record.h"
#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

constexpr int kSkipped = 77;

/// The first task has seconds left when its first record is seen.
constexpr char kConfig[] =
    "question: Does a cluster find what one machine finds?\n"
    "meshes:\n"
    "  - generator: bumpy_terrain\n"
    "    triangles: [200, 60000]\n"
    "    seed: [1, 2, 3, 4]\n"
    "  - generator: torus\n"
    "    triangles: [400, 20000]\n"
    "methods:\n"
    "  - name: quadratic\n"
    "  - name: thin\n"
    "    epsilon: 1e-2\n";
constexpr std::size_t kRuns = 20;

ProgramResult Shell(const std::string& command) {
  std::FILE* pipe = popen((command + " < /dev/null 2>&1").c_str(), "r");
  ProgramResult result;
  char block[4096];
  while (const std::size_t size = std::fread(block, 1, sizeof(block), pipe)) {
    result.output.append(block, size);
  }
  const int status = pclose(pipe);
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

/// The records of a file by key; a key twice is a failure.
std::map<std::string, Record> Records(const std::string& text) {
  std::map<std::string, Record> records;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Record record = Record::parse(line, nullptr, false);
    if (!record.is_object()) continue;
    const std::string key = record["key"];
    EXPECT_TRUE(records.emplace(key, std::move(record)).second) << "twice: " << key;
  }
  return records;
}

/// Runs the config as an array of tasks of which the first is killed and queued again, and here: both
/// end with the same records, and what the killed task had recorded was kept.
void ExpectArrayFindsWhatTheLocalRunFinds(const TemporaryFolder& folder, const std::string& config,
                                          int tasks, std::size_t runs) {
  const std::string program = ProgramFolder() + "/run_experiment";
  const ProgramResult array = Shell(ProjectPath("tests/slurm/run_array") + " " + folder.path() +
                                    " " + config + " " + program + " " + std::to_string(tasks));
  if (array.exit_status == kSkipped) GTEST_SKIP() << array.output;
  std::printf("%s", array.output.c_str());
  ASSERT_EQ(array.exit_status, 0) << folder.Read("logs/1.log") << folder.Read("logs/2.log");
  const ProgramResult local =
      RunProgram("run_experiment --parallel_runs=2 --output=" + folder.path() + "/local " + config);
  ASSERT_EQ(local.exit_status, 0) << local.output;

  const auto found = Records(folder.Read("results/results.jsonl"));
  const auto expected = Records(folder.Read("local/results.jsonl"));
  ASSERT_EQ(expected.size(), runs);
  ASSERT_EQ(found.size(), runs);
  for (const auto& [key, record] : expected) {
    ASSERT_TRUE(found.contains(key));
    for (const char* part :
         {"mesh", "method", "repeat", "outcome", "overlap", "values", "history"}) {
      EXPECT_EQ(found.at(key)[part], record[part]) << key << " " << part;
    }
  }
  // Nothing was made twice.
  const auto kept = Records(folder.Read("before_requeue.jsonl"));
  const auto first =
      Records(folder.Read("results/results.shard-1-of-" + std::to_string(tasks) + ".jsonl"));
  EXPECT_GE(kept.size(), 1u);
  EXPECT_LT(kept.size(), first.size());
  for (const auto& [key, record] : kept) EXPECT_EQ(first.at(key), record);
}

TEST(SlurmSlow, AnArrayWithAKilledTaskFindsWhatTheLocalRunFinds) {
  const TemporaryFolder folder;
  ExpectArrayFindsWhatTheLocalRunFinds(folder, folder.Write("study.yaml", kConfig), 2, kRuns);
}

constexpr int kCorpus = 100;

/// That many mesh files of every topology and format.
void WriteCorpus(const std::string& folder) {
  const char* generators[] = {"bumpy_terrain", "torus", "blob", "annulus", "double_torus"};
  const char* formats[] = {"obj", "off", "ply"};
  std::filesystem::create_directories(folder);
  for (int i = 0; i < kCorpus; ++i) {
    GeneratorOptions options;
    options.triangles = 1000 + 10 * i;
    options.seed = static_cast<unsigned>(i + 1);
    const auto mesh = GenerateMesh(generators[i % 5], options);
    ASSERT_TRUE(mesh.ok()) << mesh.status().message();
    const std::string name =
        std::string(generators[i % 5]) + std::to_string(i) + "." + formats[i / 5 % 3];
    ASSERT_TRUE(WriteMesh(folder + "/" + name, *mesh).ok()) << name;
  }
}

TEST(SlurmSlow, ACorpusOfAHundredMeshesInFourShardsIsTheLocalRun) {
  const TemporaryFolder folder;
  WriteCorpus(folder.Path("corpus"));
  const std::string config =
      folder.Write("corpus.yaml",
                   "question: Does a cluster find what one machine finds?\nmeshes:\n  - {corpus: " +
                       folder.Path("corpus") +
                       ", where: triangles > 10}\nmethods:\n  - name: default\n  - {name: "
                       "quadratic, angle_objective: quadratic}\n");
  ExpectArrayFindsWhatTheLocalRunFinds(folder, config, 4, 2 * kCorpus);
}

TEST(SlurmScript, PrintsAnArrayThatIsQueuedAgain) {
  const TemporaryFolder folder;
  const std::string config = folder.Write("a study.yaml", kConfig);
  const ProgramResult script =
      Shell(ProjectPath("experiments/scripts/submit_to_slurm") + " '" + config +
            "' --shards 5 --parallel_runs 3 --program " + ProgramFolder() +
            "/run_experiment -- --only='*/thin' --sbatch-partition=long");
  ASSERT_EQ(script.exit_status, 0) << script.output;
  for (const char* line : {"#SBATCH --array=1-5\n", "#SBATCH --cpus-per-task=3\n",
                           "#SBATCH --requeue\n", "#SBATCH --partition=\"long\"\n",
                           "/a\\ study.yaml --only=\\*/thin --parallel_runs=3 "
                           "--shard=\"$SLURM_ARRAY_TASK_ID/5\"\n"}) {
    EXPECT_THAT(script.output, HasSubstr(line));
  }
}

TEST(SlurmScript, RefusesMistakesBeforeAnythingIsSubmitted) {
  const TemporaryFolder folder;
  const std::string config = folder.Write("a.yaml", kConfig);
  const std::string bad = folder.Write("bad.yaml", "question: why\n");
  const std::string program = " --program " + ProgramFolder() + "/run_experiment";
  for (const auto& [arguments, message] : std::map<std::string, std::string>{
           {"", "usage: experiments/scripts/submit_to_slurm CONFIG.yaml"},
           {config + " --shards 0", "--shards 0: expected a whole number"},
           {config + " --shard 3", "unknown flag '--shard'"},
           {"/nowhere/a.yaml", "/nowhere/a.yaml: there is no such file"},
           {config + " --logs 'say \"x\"'", "sbatch's lines can hold no double quote"},
           {bad + program, "bad.yaml:1:1: the key 'meshes' is missing"},
           {config + program + " -- --only=zzz", "--only=zzz: no run of "}}) {
    const ProgramResult refused =
        Shell(ProjectPath("experiments/scripts/submit_to_slurm") + " " + arguments);
    EXPECT_NE(refused.exit_status, 0) << arguments;
    EXPECT_THAT(refused.output, HasSubstr(message));
  }
}

}  // namespace
}  // namespace cirque
