#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/experiment_report/runs.h"

namespace cirque::experiment_report {

/// An interval that holds the median of what was sampled at least 19 times in 20, whatever its
/// distribution: two order statistics, infinite where there are too few values (under six).
std::pair<double, double> MedianInterval(std::vector<double> values);

/// A method beside the first one, by one figure of which less is better.
struct MethodScore {
  std::string method;
  int maps = 0;  ///< meshes that it maps
  /// Whether it maps half of the meshes that some method maps; another would leave few for the rest.
  bool contends = true;
  int wins = 0;  ///< of those that every contender maps, on how many none has less than it by 0.1 %
  double median = 0;  ///< of the figure over the meshes that it maps; NaN: none
  /// Of the figure over the first method's on the same mesh, where both map it and neither is 0.
  int pairs = 0;
  double ratio = 0, ratio_low = 0, ratio_high = 0;  ///< their median and its interval
};

/// All methods by one figure.
struct Comparison {
  std::string label;  ///< as "mean quasi-conformal distortion - 1"
  std::vector<std::string> meshes, methods;
  std::vector<std::vector<double>>
      value;                        ///< [mesh][method], of several repeats the median; or NaN
  std::vector<MethodScore> scores;  ///< as `methods`
  int common = 0;                   ///< meshes that every contender maps
};

/// The methods of the runs, in the order of their first records, compared by angle distortion, area
/// distortion and CPU time, as far as they were recorded. Distortions count from what no map can
/// be below, and up to 1e-5 are 0. Empty with fewer than two methods.
std::vector<Comparison> CompareMethods(const std::vector<Run>& runs);

/// What the comparisons say, one sentence each: which method is best on the most meshes, and by what
/// ratio it differs from the first; which methods were left out of that because they map too few.
std::vector<std::string> VerdictsOf(const std::vector<Comparison>& comparisons);

/// The scores, and a table of meshes and methods for each comparison, in which the best is marked.
std::string ComparisonsHtml(const std::vector<Comparison>& comparisons);

}  // namespace cirque::experiment_report
