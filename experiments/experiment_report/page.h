#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "experiments/experiment_report/comparison.h"
#include "experiments/experiment_report/figures.h"
#include "experiments/experiment_report/runs.h"

namespace cirque::experiment_report {

/// The maps that a page shows.
struct ShownMaps {
  std::vector<std::string> keys;      ///< of their runs
  nlohmann::json views;               ///< a list: MapPayload with "key", "mesh", "method"
  std::vector<std::string> left_out;  ///< sentences: which maps are not shown, and why
};

/// Sets where every run is found in the page.
void LinkRuns(const ShownMaps& maps, std::vector<Run>* runs);

/// Reads the maps that runs kept, in the order of the runs, up to the first whose data exceeds
/// what is left of `most_bytes` of the page.
ShownMaps CollectMaps(const std::string& folder, const std::vector<Run>& runs,
                      std::size_t most_bytes);

/// The whole report as one HTML document that needs nothing else. The figures that the config asks
/// for come before those that every report has.
std::string ReportHtml(const std::string& title, const Results& results, const ShownMaps& maps,
                       const std::vector<ConfigFigure>& figures = {});

/// How many runs ended in a map, in an infeasibility certificate, and otherwise.
struct Verdicts {
  int ok = 0, infeasible = 0, failed = 0;
};
Verdicts CountVerdicts(const std::vector<Run>& runs);

/// The question, what the comparisons answer, the verdicts and what the runs were made with, as HTML.
std::string SummaryHtml(const Results& results, const std::vector<Comparison>& comparisons = {});

/// The runs as a table that sorts by the column whose head is clicked; runs with a map that the
/// page shows (by key) link to it.
std::string RunsHtml(const std::vector<Run>& runs, const std::vector<std::string>& shown_maps);

/// The runs without a map, each with its message: answers, limits that were met, and faults, which are
/// the programs' own, apart from each other and by outcome. Empty when there are none.
std::string FailuresHtml(const std::vector<Run>& runs);

/// The scripts that sort tables and that hide and show series, embedded.
extern const std::string_view kTableScript;

}  // namespace cirque::experiment_report
