#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cirque/core/status.h"

#include "experiments/experiment_report/axis.h"
#include "experiments/experiment_report/runs.h"

namespace cirque::experiment_report {

/// A figure that the experiment's config asks for, as run_experiment wrote it to figures.json.
struct ConfigFigure {
  struct Axis {
    std::string pointer;  ///< JSON pointer into a record
    std::string label;
    AxisKind kind = AxisKind::kLinear;
  };

  std::string kind;  ///< "scatter", "lines" or "histogram"
  std::string title;
  Axis x, y;               ///< no y for a histogram
  std::string by_pointer;  ///< what the runs of a series have in common
};

/// The figures of FOLDER/figures.json; none where there is no such file. Error: one that is not as
/// run_experiment writes it.
StatusOr<std::vector<ConfigFigure>> ReadConfigFigures(const std::string& folder);

/// A run's place in a figure. Without y, a histogram's.
struct FigurePoint {
  std::string series, mesh, method;
  double x = 0, y = 0;
  std::string link = {};  ///< of the run
};

/// The runs with a map that have both values, those of a line reduced to the median of equal x in
/// each series and sorted by x.
std::vector<FigurePoint> PointsOf(const ConfigFigure& figure, const std::vector<Run>& runs);

/// The charts, one after the other.
std::string ConfigFiguresHtml(const std::vector<ConfigFigure>& figures,
                              const std::vector<Run>& runs);

/// The same as data: a list of figures with title, kind, labels, scales and points, which
/// figures.py draws for papers.
std::string ConfigFiguresJson(const std::vector<ConfigFigure>& figures,
                              const std::vector<Run>& runs);

/// All charts of a study, one after the other as HTML: time against triangles, performance
/// profiles, distributions of distortion, area against angle distortion, convergence of the solves;
/// of more than 160 solves their medians.
std::string FiguresHtml(const std::vector<Run>& runs);

/// Has figures.py draw the tables as PDF files beside them, and says which. Error: no python3 or no
/// matplotlib, or what the script says.
Status DrawPaperFigures(const std::string& runs_json, const std::string& convergence_json,
                        const std::string& figures_json);

/// The Python that draws figures for papers, embedded.
extern const std::string_view kFiguresScript;

}  // namespace cirque::experiment_report
