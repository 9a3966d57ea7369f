#include "experiments/experiment_report/performance_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace cirque::experiment_report {
namespace {

/// The median (of an even number the upper one), infinite when one of them is.
double Typical(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return std::isfinite(seconds.back()) ? seconds[seconds.size() / 2] : seconds.back();
}

}  // namespace

Profiles PerformanceProfiles(const std::vector<Attempt>& attempts) {
  std::map<std::string, std::map<std::string, std::vector<double>>> by_problem;
  std::map<std::string, std::vector<double>> ratios;
  for (const Attempt& attempt : attempts) {
    by_problem[attempt.problem][attempt.method].push_back(attempt.seconds);
    ratios[attempt.method];
  }
  Profiles profiles;
  for (const auto& [problem, by_method] : by_problem) {
    if (by_method.size() != ratios.size()) continue;
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [method, seconds] : by_method) best = std::min(best, Typical(seconds));
    if (!(best > 0) || !std::isfinite(best)) continue;
    ++profiles.problems;
    for (const auto& [method, seconds] : by_method) {
      const double ratio = Typical(seconds) / best;
      if (std::isfinite(ratio)) ratios[method].push_back(ratio);
    }
  }
  for (auto& [method, values] : ratios) {
    std::sort(values.begin(), values.end());
    profiles.methods.push_back({method, values});
  }
  return profiles;
}

}  // namespace cirque::experiment_report
