#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "experiments/experiment_report/config_figures.h"
#include "experiments/experiment_report/runs.h"

namespace cirque::experiment_report {

/// The maps that a page shows.
struct ShownMaps {
  std::vector<std::string> keys;      ///< of their runs
  nlohmann::json views;               ///< a list: MapPayload with "key", "mesh", "method"
  std::vector<std::string> left_out;  ///< sentences: which maps are not shown, and why
};

/// Reads the maps that runs kept, in the order of the runs, up to the first whose data exceeds
/// what is left of `most_bytes` of the page.
ShownMaps CollectMaps(const std::string& folder, const std::vector<Run>& runs,
                      std::size_t most_bytes);

/// The whole report as one HTML document that needs nothing else. The figures that the config asks
/// for come before those that every report has.
std::string ReportHtml(const std::string& title, const Results& results, const ShownMaps& maps,
                       const std::vector<ConfigFigure>& figures = {});

}  // namespace cirque::experiment_report
