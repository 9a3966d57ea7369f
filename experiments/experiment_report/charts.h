#pragma once

#include <string>
#include <vector>

#include "experiments/experiment_report/chart_frame.h"

namespace cirque::experiment_report {

struct Point {
  int series = 0;
  double x = 0, y = 0;
  std::string title;
  std::string link = {};  ///< where a click leads; empty: nowhere
};

/// One mark a point. Points that an axis cannot show are left out, and counted below the chart.
std::string ScatterChart(const ChartText& text, const SeriesNames& series,
                         const std::vector<Point>& points);

struct Curve {
  int series = 0;
  std::vector<double> x, y;
  std::string title;
};

/// What lies between two heights over the same places.
struct Band {
  int series = 0;
  std::vector<double> x, low, high;
  std::string title;
};

/// One mark a curve, and one a band behind them. As steps, a curve keeps its height up to the next
/// point.
std::string CurveChart(const ChartText& text, const SeriesNames& series,
                       const std::vector<Curve>& curves, bool steps,
                       const std::vector<Band>& bands = {});

/// The median of every series' curves at x = 0, 1, ... and the band from their lower to their upper
/// decile, in place of more lines than an eye can follow. A curve that has ended keeps its height;
/// heights that are no positive numbers are passed over.
struct Summary {
  std::vector<Curve> medians;
  std::vector<Band> bands;
};
Summary Summarize(const SeriesNames& series, const std::vector<Curve>& curves);

struct Sample {
  int series = 0;
  double value = 0;
};

/// Bars of the samples' numbers, those of the series on top of each other. The kinds of
/// axes follow from the numbers.
std::string HistogramChart(const ChartText& text, const SeriesNames& series,
                           const std::vector<Sample>& samples);

/// One timed attempt; `seconds` is infinite where it failed.
struct Attempt {
  std::string problem, method;
  double seconds = 0;
};

/// How often a method comes within a factor of the fastest one.
struct Profile {
  std::string method;
  std::vector<double> ratios;  ///< of the problems it solved, increasing: time over the best time
};

struct Profiles {
  std::vector<Profile> methods;  ///< by name
  int problems = 0;              ///< that count
};

/// Performance profiles (E. Dolan, J. Moré, Benchmarking optimization software with performance
/// profiles, Math. Programming 91, 2002): rho(tau) = share of problems with ratio <= tau. Only
/// problems that every method attempted and one of them solved count. Of several attempts of one
/// method on a problem the median time counts, and no failure is allowed.
Profiles PerformanceProfiles(const std::vector<Attempt>& attempts);

}  // namespace cirque::experiment_report
