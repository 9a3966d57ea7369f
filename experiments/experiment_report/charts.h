#pragma once

#include <string>
#include <vector>

#include "experiments/experiment_report/axis.h"

namespace cirque::experiment_report {

/// What a chart is called and what its axes are. Charts are HTML figure elements with an inline SVG
/// that takes its colours from the page's style sheet: series i has the class "s" + i mod 8, from
/// the ninth on also "again" (lines are dashed), and points of every series have one of 4 shapes.
/// Every mark has the class "mark" and a title for the pointer.
struct ChartText {
  std::string title;
  std::string x_label, y_label;
  AxisKind x_kind = AxisKind::kLinear, y_kind = AxisKind::kLinear;
  std::string note = {};  ///< below it, plain text
};

/// The names of the series, which marks refer to by position.
using SeriesNames = std::vector<std::string>;

struct Point {
  int series = 0;
  double x = 0, y = 0;
  std::string title;
};

/// One mark a point. Points that an axis cannot show are left out, and counted below the chart.
std::string ScatterChart(const ChartText& text, const SeriesNames& series,
                         const std::vector<Point>& points);

struct Curve {
  int series = 0;
  std::vector<double> x, y;
  std::string title;
};

/// One mark a curve. As steps, a curve keeps its height up to the next point.
std::string CurveChart(const ChartText& text, const SeriesNames& series,
                       const std::vector<Curve>& curves, bool steps);

struct Sample {
  int series = 0;
  double value = 0;
};

/// Bars of the samples' numbers, those of the series on top of each other. The kinds of
/// axes follow from the numbers.
std::string HistogramChart(const ChartText& text, const SeriesNames& series,
                           const std::vector<Sample>& samples);

}  // namespace cirque::experiment_report
