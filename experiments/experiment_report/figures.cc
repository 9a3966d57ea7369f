#include "experiments/experiment_report/figures.h"

#include <algorithm>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "experiments/experiment_report/chart_frame.h"
#include "experiments/experiment_report/charts.h"
#include "experiments/experiment_report/html.h"
#include "experiments/experiment_report/performance_profile.h"

namespace cirque::experiment_report {
namespace {

using nlohmann::json;

/// The distinct names, sorted, and the position of each.
class Series {
 public:
  template <class Get>
  Series(const std::vector<Run>& runs, Get get) {
    std::set<std::string> names;
    for (const Run& run : runs) names.insert(get(run));
    names_.assign(names.begin(), names.end());
  }
  int Of(const std::string& name) const {
    return static_cast<int>(std::lower_bound(names_.begin(), names_.end(), name) - names_.begin());
  }
  const SeriesNames& names() const { return names_; }

 private:
  SeriesNames names_;
};

Series Methods(const std::vector<Run>& runs) {
  return Series(runs, [](const Run& run) { return run.method; });
}

std::string PointTitle(const Run& run, double x, double y) {
  return fmt::format("{} - {}: {}, {}", run.mesh, run.method, ShownNumber(x), ShownNumber(y));
}

std::string TimeScatter(const std::vector<Run>& maps) {
  const Series methods = Methods(maps);
  std::vector<Point> points;
  for (const Run& run : maps) {
    points.push_back({methods.Of(run.method), run.triangles, run.seconds,
                      PointTitle(run, run.triangles, run.seconds)});
  }
  return ScatterChart({"Time against size", "triangles", "time [s]", true, true, ""},
                      methods.names(), points);
}

std::string DistortionScatter(const std::vector<Run>& maps) {
  const Series methods = Methods(maps);
  std::vector<Point> points;
  for (const Run& run : maps) {
    const double qc = run.Value("quasi_conformal_mean"), area = run.Value("log_area_ratio_l2");
    points.push_back({methods.Of(run.method), qc, area, PointTitle(run, qc, area)});
  }
  return ScatterChart({"Area against angle distortion", "mean quasi-conformal ratio",
                       "log area ratio, root mean square", false, false, ""},
                      methods.names(), points);
}

std::string Histogram(const std::vector<Run>& maps, const std::string& value,
                      const std::string& title, const std::string& label) {
  const Series methods = Methods(maps);
  std::vector<Sample> samples;
  for (const Run& run : maps) samples.push_back({methods.Of(run.method), run.Value(value)});
  return HistogramChart({title, label, "runs", false, false, ""}, methods.names(), samples);
}

/// A failed attempt at a mesh takes forever; a proof that there is no map is no solution.
std::vector<Attempt> Attempts(const std::vector<Run>& runs) {
  std::vector<Attempt> attempts;
  for (const Run& run : runs) {
    attempts.push_back({run.mesh + "/" + run.mesh_hash, run.method,
                        run.IsOk() ? run.seconds : std::numeric_limits<double>::infinity()});
  }
  return attempts;
}

std::string ProfileChart(const std::vector<Run>& runs) {
  const Profiles profiles = PerformanceProfiles(Attempts(runs));
  ChartText text{
      "Performance profiles", "time over the best time", "share of meshes", true, false, ""};
  if (profiles.methods.size() < 2) return EmptyFigure(text, "They compare two or more methods.");
  if (profiles.problems == 0) {
    return EmptyFigure(text, "There is no mesh yet that all methods have run on.");
  }
  text.note =
      fmt::format("{} meshes that every method ran on and one of them mapped.", profiles.problems);
  double last = 1.1;
  for (const Profile& profile : profiles.methods) {
    if (!profile.ratios.empty()) last = std::max(last, profile.ratios.back());
  }
  SeriesNames names;
  std::vector<Curve> curves;
  for (const Profile& profile : profiles.methods) {
    Curve curve{static_cast<int>(names.size()), {1}, {0}, profile.method};
    for (std::size_t i = 0; i < profile.ratios.size(); ++i) {
      curve.x.push_back(profile.ratios[i]);
      curve.y.push_back((i + 1.0) / profiles.problems);
    }
    curve.x.push_back(last);
    curve.y.push_back(curve.y.back());
    names.push_back(profile.method);
    curves.push_back(curve);
  }
  return CurveChart(text, names, curves, true);
}

/// The curve of one history, gradients that are no positive numbers left out when it is drawn.
Curve HistoryCurve(const Run& run, const json& history, int series, const std::string& strategy) {
  Curve curve{series, {}, {}, run.mesh + " - " + run.method + " - " + strategy};
  for (const json& gradient : history) {
    curve.x.push_back(static_cast<double>(curve.x.size()));
    curve.y.push_back(gradient.is_number() ? gradient.get<double>()
                                           : std::numeric_limits<double>::quiet_NaN());
  }
  return curve;
}

template <class Get>
std::string ConvergenceChart(const std::vector<Run>& runs, const std::string& stage,
                             const std::string& title, Get strategy) {
  const json::json_pointer pointer("/history/" + stage);
  std::vector<Run> with_history;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(with_history), [&](const Run& run) {
    return run.record.contains(pointer) && run.record.at(pointer).is_array();
  });
  const Series strategies(with_history, strategy);
  std::vector<Curve> curves;
  for (const Run& run : with_history) {
    curves.push_back(
        HistoryCurve(run, run.record.at(pointer), strategies.Of(strategy(run)), strategy(run)));
  }
  return CurveChart({title, "iteration", "largest gradient entry", false, true, ""},
                    strategies.names(), curves, false);
}

}  // namespace

std::string FiguresHtml(const std::vector<Run>& runs) {
  std::vector<Run> maps;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(maps),
               [](const Run& run) { return run.IsOk(); });
  return TimeScatter(maps) + ProfileChart(runs) +
         Histogram(maps, "quasi_conformal_mean", "Angle distortion, mean",
                   "mean quasi-conformal ratio") +
         Histogram(maps, "quasi_conformal_max", "Angle distortion, maximum",
                   "largest quasi-conformal ratio") +
         DistortionScatter(maps) +
         ConvergenceChart(runs, "angles", "Convergence of the angle fit",
                          [](const Run& run) { return run.angle_strategy; }) +
         ConvergenceChart(runs, "radii", "Convergence of the log radii",
                          [](const Run& run) { return run.strategy; });
}

}  // namespace cirque::experiment_report
