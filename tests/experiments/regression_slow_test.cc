// What the code makes today beside what it made when results were written down.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

/// A figure of a page of results/, and the study that wrote it.
struct Sample {
  std::string page, study;
  nlohmann::json cell;
};

/// What stands between the words in the text, or nothing.
std::string Between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t begin = text.find(before);
  const std::size_t end = begin == std::string::npos ? begin : text.find(after, begin);
  return end == std::string::npos ? ""
                                  : text.substr(begin + before.size(), end - begin - before.size());
}

std::vector<Sample> SamplesOf(const fs::path& page) {
  std::ifstream file(page);
  std::vector<Sample> samples;
  std::string study;
  for (std::string line; std::getline(file, line);) {
    if (study.empty()) study = Between(line, "make_study ", "`");
    const std::string cell = Between(line, "<!-- sample ", " -->");
    if (!cell.empty()) samples.push_back({page.filename(), study, nlohmann::json::parse(cell)});
  }
  return samples;
}

constexpr char kDistortion[] = "quasi_conformal_mean", kValue[] = "energy_value";

/// The figure that the cell holds: of a map its distortion, else the value of an energy.
const char* FigureOf(const nlohmann::json& cell) {
  return cell.contains(kDistortion) ? kDistortion : kValue;
}

/// The figure that the run of the cell has today; NaN with the reason where it has none.
double FigureToday(const Sample& sample, std::string* why) {
  const TemporaryFolder folder;
  const std::string label =
      sample.cell["mesh"].get<std::string>() + "/" + sample.cell["method"].get<std::string>();
  const auto made =
      RunProgram("run_experiment '" + ProjectPath("configs/" + sample.study + ".yaml") +
                 "' --only='" + label + "' --output='" + folder.path() + "' --report=false");
  *why = made.output;
  std::ifstream records(folder.Path("results.jsonl"));
  for (std::string line; std::getline(records, line);) {
    const nlohmann::json record = nlohmann::json::parse(line);
    if (record["mesh"]["name"] != sample.cell["mesh"]) continue;
    if (record["method"]["name"] != sample.cell["method"]) continue;
    const char* figure = FigureOf(sample.cell);
    if (record["values"].contains(figure)) return record["values"][figure].get<double>();
  }
  return std::nan("");
}

/// Whether the cell is of another project's program that is not on this machine.
bool IsOfAMissingPeer(const Sample& sample, const std::string& output) {
  const std::string peer = sample.cell["method"];
  return output.find("peer '" + peer + "' left out") != std::string::npos;
}

TEST(RegressionSlow, PagesOfResultsAreWhatTheCodeMakesToday) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(ProjectPath("results"))) {
    if (entry.path().extension() != ".md") continue;
    for (const Sample& sample : SamplesOf(entry.path())) {
      std::string why;
      const std::string figure = FigureOf(sample.cell);
      const double before = sample.cell[figure].get<double>();
      const double today = FigureToday(sample, &why);
      if (IsOfAMissingPeer(sample, why)) continue;
      const double scale = figure == kDistortion ? 0.01 * (before - 1) : 1e-6 * std::abs(before);
      EXPECT_NEAR(today, before, scale + 1e-6)
          << sample.page << ", " << sample.cell.dump() << ": experiments/scripts/make_study "
          << sample.study << " makes the page anew\n"
          << why;
      ++count;
    }
  }
  EXPECT_GT(count, 0);
}

TEST(RegressionSlow, NoMapIsLostOrWorseThanTheLastReleases) {
  if (!fs::exists("/usr/share/doc/libcgal-dev/data.tar.gz")) {
    GTEST_SKIP() << "libcgal-demo is not installed";
  }
  const TemporaryFolder folder;
  const auto made =
      RunProgram("run_experiment '" + ProjectPath("configs/regression.yaml") + "' --output='" +
                 folder.path() + "' --parallel_runs=2 --report=false");
  ASSERT_EQ(made.exit_status, 0) << made.output;
  const auto compared = RunShell("'" + ProjectPath("experiments/compare") + "' '" +
                                 ProjectPath("results/reference") + "' '" + folder.path() + "'");
  EXPECT_EQ(compared.exit_status, 0)
      << compared.output << "If that is meant: experiments/run configs/regression.yaml and "
      << "experiments/scripts/keep_reference results/runs/regression results/reference";
}

}  // namespace
}  // namespace cirque
