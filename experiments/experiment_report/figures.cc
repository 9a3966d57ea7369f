#include "experiments/experiment_report/figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "experiments/common/map_view/html.h"
#include "experiments/common/process.h"
#include "experiments/common/records.h"
#include "experiments/experiment_report/chart_frame.h"
#include "experiments/experiment_report/charts.h"

namespace cirque::experiment_report {
namespace {

using nlohmann::json;

constexpr AxisKind kLog = AxisKind::kLogarithmic;

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
                      PointTitle(run, run.triangles, run.seconds), run.link});
  }
  return ScatterChart({"Time against size", "triangles", "time [s]", kLog, kLog, ""},
                      methods.names(), points);
}

// Less distortion is drawn as this: it would only stretch the logarithmic axes.
constexpr double kLeastDistortion = 1e-5;
constexpr char kLeastNote[] = "Less than 1e-5 is shown as 1e-5.";

/// NaN stays NaN.
double Shown(double distortion) {
  return distortion < kLeastDistortion ? kLeastDistortion : distortion;
}

/// Says so where one of the values is drawn as the least.
std::string LeastNote(const std::vector<double>& shown) {
  return std::find(shown.begin(), shown.end(), kLeastDistortion) == shown.end() ? "" : kLeastNote;
}

/// How far a ratio that is at least 1 exceeds it.
double Excess(const Run& run, const std::string& ratio) { return Shown(run.Value(ratio) - 1); }

double AreaDistortion(const Run& run) { return Shown(run.Value("log_area_ratio_l2")); }

std::string DistortionScatter(const std::vector<Run>& maps) {
  const Series methods = Methods(maps);
  std::vector<Point> points;
  std::vector<double> shown;
  for (const Run& run : maps) {
    const double angle = Excess(run, "quasi_conformal_mean"), area = AreaDistortion(run);
    shown.insert(shown.end(), {angle, area});
    points.push_back({methods.Of(run.method), angle, area, PointTitle(run, angle, area), run.link});
  }
  return ScatterChart({"Area against angle distortion", "mean quasi-conformal ratio - 1",
                       "log area ratio, root mean square", kLog, kLog, LeastNote(shown)},
                      methods.names(), points);
}

/// How many of a method's maps have at most so much: lines can be told apart where bars cover each
/// other.
template <class Get>
std::string Distribution(const std::vector<Run>& maps, const std::string& title,
                         const std::string& label, Get value) {
  const Series methods = Methods(maps);
  std::vector<std::vector<double>> samples(methods.names().size());
  std::vector<double> shown;
  for (const Run& run : maps) {
    const double own = value(run);
    if (!std::isfinite(own)) continue;
    shown.push_back(own);
    samples[methods.Of(run.method)].push_back(own);
  }
  std::vector<Curve> curves;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    std::vector<double>& own = samples[s];
    if (own.empty()) continue;
    std::sort(own.begin(), own.end());
    Curve curve{static_cast<int>(s), {own[0]}, {0}, methods.names()[s]};
    for (std::size_t i = 0; i < own.size(); ++i) {
      curve.x.push_back(own[i]);
      curve.y.push_back(static_cast<double>(i + 1) / static_cast<double>(own.size()));
    }
    curves.push_back(std::move(curve));
  }
  return CurveChart({title, label, "share of maps", kLog, AxisKind::kLinear, LeastNote(shown)},
                    methods.names(), curves, true);
}

std::string Distributions(const std::vector<Run>& maps) {
  return Distribution(maps, "Angle distortion, mean", "mean quasi-conformal ratio - 1",
                      [](const Run& run) { return Excess(run, "quasi_conformal_mean"); }) +
         Distribution(maps, "Angle distortion, maximum", "largest quasi-conformal ratio - 1",
                      [](const Run& run) { return Excess(run, "quasi_conformal_max"); }) +
         Distribution(maps, "Area distortion", "log area ratio, root mean square", AreaDistortion);
}

/// A failed attempt at a mesh takes forever; an infeasibility certificate is no solution.
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
  ChartText text{"Performance profiles", "time over the best time",
                 "share of meshes",      kLog,
                 AxisKind::kLinear,      ""};
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

constexpr std::size_t kMostLines = 160;  ///< that are drawn one by one

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
  // Where all runs have one strategy, their methods tell them apart.
  const Series strategies(with_history, strategy), methods = Methods(with_history);
  const bool by_method = strategies.names().size() == 1;
  std::vector<Curve> curves;
  for (const Run& run : with_history) {
    const int series = by_method ? methods.Of(run.method) : strategies.Of(strategy(run));
    curves.push_back(HistoryCurve(run, run.record.at(pointer), series, strategy(run)));
  }
  const SeriesNames& series = by_method ? methods.names() : strategies.names();
  ChartText text{title, "iteration", "largest gradient entry", AxisKind::kWhole, kLog, ""};
  if (curves.size() <= kMostLines) return CurveChart(text, series, curves, false);
  text.note = fmt::format(
      "Medians of {} solves, and the band from their lower to their upper decile; a solve that has "
      "ended keeps its last gradient.",
      curves.size());
  const Summary summary = Summarize(series, curves);
  return CurveChart(text, series, summary.medians, false, summary.bands);
}

/// Nothing where no run minimises an energy by itself, which few experiments do.
std::string EnergyConvergence(const std::vector<Run>& runs) {
  const json::json_pointer pointer("/history/energy");
  const auto has_one = [&](const Run& run) { return run.record.contains(pointer); };
  if (std::none_of(runs.begin(), runs.end(), has_one)) return "";
  return ConvergenceChart(runs, "energy", "Convergence of the energies", [](const Run& run) {
    return TextAt(run.record, "/method/energy_solver");
  });
}

constexpr char kLooksForMatplotlib[] =
    "import importlib.util as u; raise SystemExit(u.find_spec('matplotlib') is None)";

}  // namespace

std::string FiguresHtml(const std::vector<Run>& runs) {
  std::vector<Run> maps;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(maps),
               [](const Run& run) { return run.IsOk(); });
  return TimeScatter(maps) + ProfileChart(runs) + Distributions(maps) + DistortionScatter(maps) +
         ConvergenceChart(runs, "angles", "Convergence of the angle fit",
                          [](const Run& run) { return run.angle_solver; }) +
         ConvergenceChart(runs, "radii", "Convergence of the log radii",
                          [](const Run& run) { return run.radii_solver; }) +
         EnergyConvergence(runs);
}

Status DrawPaperFigures(const std::string& runs_json, const std::string& convergence_json,
                        const std::string& figures_json) {
  std::fflush(stdout);  // what it prints comes after our lines
  // Another Python than the system's may come first in PATH, without the system's packages.
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    if (RunAndWait({python, "-c", kLooksForMatplotlib}) != 0) continue;
    const int status = RunAndWait(
        {python, "-c", std::string(kFiguresScript), runs_json, convergence_json, figures_json});
    if (status == 0) return Status();
    return Status::InvalidInput("--pdf: " + python + " could not draw, for the reason above");
  }
  return Status::InvalidInput(
      "--pdf: no python3 with matplotlib; on Debian: apt-get install python3-matplotlib. All else "
      "has been written");
}

}  // namespace cirque::experiment_report
