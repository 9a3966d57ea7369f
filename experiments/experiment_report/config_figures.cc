#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "experiments/common/map_view/html.h"
#include "experiments/common/records.h"
#include "experiments/experiment_report/charts.h"
#include "experiments/experiment_report/figures.h"

namespace cirque::experiment_report {
namespace {

using nlohmann::json;

/// The pointer of an axis; throws where it is none.
std::string PointerOf(const json& axis) {
  return json::json_pointer(axis.at("pointer").get<std::string>()).to_string();
}

ConfigFigure::Axis ReadAxis(const json& axis, bool logarithmic) {
  return {PointerOf(axis), axis.at("label"),
          logarithmic ? AxisKind::kLogarithmic : AxisKind::kLinear};
}

ConfigFigure ReadFigure(const json& entry) {
  ConfigFigure figure;
  figure.kind = entry.at("kind");
  figure.title = entry.at("title");
  figure.by_pointer = PointerOf(entry.at("by"));
  const std::string scale = entry.at("scale");
  figure.x = ReadAxis(entry.at("x"), scale == "log" || scale == "log_x");
  if (figure.kind != "histogram") {
    figure.y = ReadAxis(entry.at("y"), scale == "log" || scale == "log_y");
  }
  return figure;
}

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// One point for every series and x, in this order.
std::vector<FigurePoint> Medians(const std::vector<FigurePoint>& points) {
  std::map<std::pair<std::string, double>, std::vector<double>> heights;
  for (const FigurePoint& point : points) heights[{point.series, point.x}].push_back(point.y);
  std::vector<FigurePoint> medians;
  for (const auto& [place, values] : heights) {
    medians.push_back({place.first, fmt::format("median of {}", values.size()), "", place.second,
                       Median(values)});
  }
  return medians;
}

SeriesNames SeriesOf(const std::vector<FigurePoint>& points) {
  SeriesNames names;
  for (const FigurePoint& point : points) names.push_back(point.series);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

int NumberOf(const SeriesNames& series, const std::string& name) {
  return static_cast<int>(std::lower_bound(series.begin(), series.end(), name) - series.begin());
}

std::string Scatter(const ChartText& text, const SeriesNames& series,
                    const std::vector<FigurePoint>& points) {
  std::vector<Point> marks;
  for (const FigurePoint& point : points) {
    marks.push_back({NumberOf(series, point.series), point.x, point.y,
                     fmt::format("{} - {}: {}, {}", point.mesh, point.method, ShownNumber(point.x),
                                 ShownNumber(point.y)),
                     point.link});
  }
  return ScatterChart(text, series, marks);
}

std::string Lines(const ChartText& text, const SeriesNames& series,
                  const std::vector<FigurePoint>& points) {
  std::vector<Curve> curves;
  for (const std::string& name : series) {
    curves.push_back({static_cast<int>(curves.size()), {}, {}, name});
  }
  for (const FigurePoint& point : points) {
    Curve& curve = curves[NumberOf(series, point.series)];
    curve.x.push_back(point.x);
    curve.y.push_back(point.y);
  }
  return CurveChart(text, series, curves, false);
}

std::string Chart(const ConfigFigure& figure, const std::vector<Run>& runs) {
  const std::vector<FigurePoint> points = PointsOf(figure, runs);
  const SeriesNames series = SeriesOf(points);
  const ChartText text{figure.title, figure.x.label, figure.y.label, figure.x.kind, figure.y.kind};
  if (figure.kind == "lines") return Lines(text, series, points);
  if (figure.kind == "scatter") return Scatter(text, series, points);
  std::vector<Sample> samples;
  for (const FigurePoint& point : points) {
    samples.push_back({NumberOf(series, point.series), point.x});
  }
  return HistogramChart({figure.title, figure.x.label, "runs"}, series, samples);
}

std::string ScaleOf(const ConfigFigure::Axis& axis) {
  return axis.kind == AxisKind::kLogarithmic ? "log" : "linear";
}

}  // namespace

StatusOr<std::vector<ConfigFigure>> ReadConfigFigures(const std::string& folder) {
  std::vector<ConfigFigure> figures;
  const std::filesystem::path path = std::filesystem::path(folder) / "figures.json";
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return figures;
  try {
    for (const json& entry : json::parse(std::ifstream(path))) {
      figures.push_back(ReadFigure(entry));
    }
  } catch (const json::exception& problem) {
    return Status::InvalidInput(fmt::format("{}: not as run_experiment writes it ({}); remove it",
                                            path.string(), problem.what()));
  }
  return figures;
}

std::vector<FigurePoint> PointsOf(const ConfigFigure& figure, const std::vector<Run>& runs) {
  std::vector<FigurePoint> points;
  const bool counts = figure.kind == "histogram";
  for (const Run& run : runs) {
    const double x = NumberAt(run.record, figure.x.pointer);
    const double y = counts ? 0 : NumberAt(run.record, figure.y.pointer);
    if (!run.IsOk() || std::isnan(x) || std::isnan(y)) continue;
    points.push_back({TextAt(run.record, figure.by_pointer), run.mesh, run.method, x, y, run.link});
  }
  return figure.kind == "lines" ? Medians(points) : points;
}

std::string ConfigFiguresHtml(const std::vector<ConfigFigure>& figures,
                              const std::vector<Run>& runs) {
  std::string html;
  for (const ConfigFigure& figure : figures) html += Chart(figure, runs);
  return html;
}

std::string ConfigFiguresJson(const std::vector<ConfigFigure>& figures,
                              const std::vector<Run>& runs) {
  json list = json::array();
  for (const ConfigFigure& figure : figures) {
    json points = json::array();
    for (const FigurePoint& p : PointsOf(figure, runs)) points.push_back({p.series, p.x, p.y});
    list.push_back({{"kind", figure.kind},
                    {"title", figure.title},
                    {"x_label", figure.x.label},
                    {"y_label", figure.y.label},
                    {"x_scale", ScaleOf(figure.x)},
                    {"y_scale", ScaleOf(figure.y)},
                    {"points", points}});
  }
  return list.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace cirque::experiment_report
