#include "experiments/experiment_report/charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "experiments/common/map_view/html.h"

namespace cirque::experiment_report {
namespace {

constexpr int kBins = 16;
constexpr double kLogarithmicRange = 20;  // a histogram over more than this factor has log bins

template <class Items, class Get>
std::vector<double> Collect(const Items& items, Get get) {
  std::vector<double> values;
  for (const auto& item : items) values.push_back(get(item));
  return values;
}

std::string LeftOut(std::size_t number, std::size_t total) {
  if (number == 0) return "";
  return fmt::format("{} of {} runs are not shown: the value is missing or not positive.", number,
                     total);
}

std::string CurvePath(const ChartFrame& frame, const Curve& curve, bool steps) {
  std::string path;
  bool is_point = true;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!frame.Shows(curve.x[i], curve.y[i])) continue;
    const double x = frame.X(curve.x[i]), y = frame.Y(curve.y[i]);
    if (path.empty()) {
      path = fmt::format("M{:.1f} {:.1f}", x, y);
      continue;
    }
    path += steps ? fmt::format("H{:.1f}V{:.1f}", x, y) : fmt::format("L{:.1f} {:.1f}", x, y);
    is_point = false;
  }
  return !path.empty() && is_point ? path + "h0" : path;  // its round ends make a dot
}

/// Along the upper heights and back along the lower ones.
std::string BandPath(const ChartFrame& frame, const Band& band) {
  std::string there, back;
  for (std::size_t i = 0; i < band.x.size(); ++i) {
    if (!frame.Shows(band.x[i], band.low[i]) || !frame.Shows(band.x[i], band.high[i])) continue;
    const double x = frame.X(band.x[i]);
    there += fmt::format("{}{:.1f} {:.1f}", there.empty() ? 'M' : 'L', x, frame.Y(band.high[i]));
    back = fmt::format("L{:.1f} {:.1f}", x, frame.Y(band.low[i])) + back;
  }
  return there.empty() ? "" : there + back + "z";
}

/// The value below which a share of the sorted ones lies.
double Quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// The heights of the curves at the i-th place, sorted.
std::vector<double> HeightsAt(const std::vector<const Curve*>& curves, std::size_t i) {
  std::vector<double> heights;
  for (const Curve* curve : curves) {
    const double height = curve->y[std::min(i, curve->y.size() - 1)];
    if (height > 0) heights.push_back(height);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// The borders of the bins, which the axis' range is cut into evenly.
std::vector<double> BinBorders(const Axis& axis) {
  std::vector<double> borders;
  for (int i = 0; i <= kBins; ++i) {
    const double t = static_cast<double>(i) / kBins;
    borders.push_back(axis.logarithmic() ? axis.low() * std::pow(axis.high() / axis.low(), t)
                                         : axis.low() + t * (axis.high() - axis.low()));
  }
  return borders;
}

/// numbers[bin][series].
std::vector<std::vector<int>> CountBins(const Axis& axis, std::size_t series,
                                        const std::vector<Sample>& samples) {
  std::vector<std::vector<int>> numbers(kBins, std::vector<int>(series));
  for (const Sample& sample : samples) {
    if (!axis.Shows(sample.value)) continue;
    const int bin = static_cast<int>(axis.Position(sample.value) * kBins);
    ++numbers[std::clamp(bin, 0, kBins - 1)][sample.series];
  }
  return numbers;
}

std::string Bars(const ChartFrame& frame, const std::vector<std::vector<int>>& numbers,
                 const SeriesNames& series) {
  const std::vector<double> borders = BinBorders(frame.x());
  std::string marks;
  for (int bin = 0; bin < kBins; ++bin) {
    int below = 0;
    for (std::size_t s = 0; s < series.size(); ++s) {
      const int number = numbers[bin][s];
      if (number == 0) continue;
      const double x = frame.X(borders[bin]), width = frame.X(borders[bin + 1]) - x;
      const double top = frame.Y(below + number), bottom = frame.Y(below);
      marks += fmt::format(
          "<rect {} x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">{}</rect>",
          MarkClass(static_cast<int>(s)), x + 1, top, width - 2, bottom - top,
          TitleElement(fmt::format("{}: {} between {:.4g} and {:.4g}", series[s], number,
                                   borders[bin], borders[bin + 1])));
      below += number;
    }
  }
  return marks;
}

}  // namespace

std::string ScatterChart(const ChartText& text, const SeriesNames& series,
                         const std::vector<Point>& points) {
  const ChartFrame frame(
      text, Axis(text.x_label, text.x_kind, Collect(points, [](const Point& p) { return p.x; })),
      Axis(text.y_label, text.y_kind, Collect(points, [](const Point& p) { return p.y; })));
  std::string marks;
  std::size_t shown = 0;
  for (const Point& point : points) {
    if (!frame.Shows(point.x, point.y)) continue;
    marks +=
        Marker(point.series, frame.X(point.x), frame.Y(point.y), point.title, point.link) + "\n";
    ++shown;
  }
  if (shown == 0) return EmptyFigure(text, "No run has both values.");
  return frame.Figure(series, marks, LeftOut(points.size() - shown, points.size()));
}

std::string CurveChart(const ChartText& text, const SeriesNames& series,
                       const std::vector<Curve>& curves, bool steps,
                       const std::vector<Band>& bands) {
  std::vector<double> all_x, all_y;
  for (const Band& band : bands) {
    all_x.insert(all_x.end(), band.x.begin(), band.x.end());
    all_y.insert(all_y.end(), band.low.begin(), band.low.end());
    all_y.insert(all_y.end(), band.high.begin(), band.high.end());
  }
  for (const Curve& curve : curves) {
    all_x.insert(all_x.end(), curve.x.begin(), curve.x.end());
    all_y.insert(all_y.end(), curve.y.begin(), curve.y.end());
  }
  const ChartFrame frame(text, Axis(text.x_label, text.x_kind, all_x),
                         Axis(text.y_label, text.y_kind, all_y));
  std::string marks;
  for (const Band& band : bands) {
    marks += fmt::format("<path {} d=\"{}\">{}</path>\n", MarkClass(band.series, " band"),
                         BandPath(frame, band), TitleElement(band.title));
  }
  for (const Curve& curve : curves) {
    const std::string path = CurvePath(frame, curve, steps);
    if (path.empty()) continue;
    marks += fmt::format("<path {} d=\"{}\">{}</path>\n", MarkClass(curve.series, " line"), path,
                         TitleElement(curve.title));
  }
  if (marks.empty()) return EmptyFigure(text, "No run has such a curve.");
  return frame.Figure(series, marks, "");
}

Summary Summarize(const SeriesNames& series, const std::vector<Curve>& curves) {
  std::vector<std::vector<const Curve*>> members(series.size());
  for (const Curve& curve : curves) {
    if (!curve.y.empty()) members[curve.series].push_back(&curve);
  }
  Summary summary;
  for (std::size_t s = 0; s < series.size(); ++s) {
    std::size_t longest = 0;
    for (const Curve* curve : members[s]) longest = std::max(longest, curve->y.size());
    const int number = static_cast<int>(s);
    Curve median{number, {}, {}, series[s] + ": median"};
    Band band{number, {}, {}, {}, series[s] + ": lower to upper decile"};
    for (std::size_t i = 0; i < longest; ++i) {
      const std::vector<double> heights = HeightsAt(members[s], i);
      if (heights.empty()) continue;
      median.x.push_back(static_cast<double>(i));
      median.y.push_back(Quantile(heights, 0.5));
      band.low.push_back(Quantile(heights, 0.1));
      band.high.push_back(Quantile(heights, 0.9));
    }
    if (median.x.empty()) continue;
    band.x = median.x;
    summary.medians.push_back(std::move(median));
    summary.bands.push_back(std::move(band));
  }
  return summary;
}

std::string HistogramChart(const ChartText& text, const SeriesNames& series,
                           const std::vector<Sample>& samples) {
  std::vector<double> values;
  for (const Sample& sample : samples) {
    if (std::isfinite(sample.value)) values.push_back(sample.value);
  }
  if (values.empty()) return EmptyFigure(text, "No run has this value.");
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const bool logarithmic = *low > 0 && *high > kLogarithmicRange * *low;
  const Axis x(text.x_label, logarithmic ? AxisKind::kLogarithmic : AxisKind::kLinear, values);
  const std::vector<std::vector<int>> numbers = CountBins(x, series.size(), samples);
  std::vector<double> heights = {0};
  for (const std::vector<int>& bin : numbers) {
    int height = 0;
    for (const int number : bin) height += number;
    heights.push_back(height);
  }
  const ChartFrame frame(text, x, Axis(text.y_label, AxisKind::kWhole, heights));
  return frame.Figure(series, Bars(frame, numbers, series),
                      LeftOut(samples.size() - values.size(), samples.size()));
}

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
