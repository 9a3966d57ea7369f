#pragma once

#include <string>
#include <vector>

#include "experiments/experiment_report/runs.h"

namespace cirque::experiment_report {

/// How many runs ended in a map, in a proof that there is none, and otherwise.
struct Verdicts {
  int ok = 0, infeasible = 0, failed = 0;
};
Verdicts CountVerdicts(const std::vector<Run>& runs);

/// The question, the verdicts and what the runs were made with, as HTML.
std::string SummaryHtml(const Results& results);

/// The runs as a table that sorts by the column whose head is clicked; runs with a map that the
/// page shows (by key) link to it.
std::string RunsHtml(const std::vector<Run>& runs, const std::vector<std::string>& shown_maps);

/// The runs without a map, by outcome, each with its message; empty when there are none.
std::string FailuresHtml(const std::vector<Run>& runs);

}  // namespace cirque::experiment_report
