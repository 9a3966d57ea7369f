#include "experiments/experiment_report/chart_frame.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiments/common/map_view/html.h"

namespace cirque::experiment_report {
namespace {

// The drawing in units of the SVG: it grows with the page.
constexpr double kWidth = 480, kHeight = 320;
constexpr double kLeft = 62, kRight = 24, kTop = 12, kBottom = 46;
constexpr double kMarkerSize = 3.6;
constexpr int kColours = 8, kShapes = 4;

/// The parts of a name, which commas divide.
std::vector<std::string> PartsOf(const std::string& name) {
  std::vector<std::string> parts(1);
  for (const char c : name) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// The names without the parts that all of them have; whole where one would be left without any.
SeriesNames WhatVaries(const SeriesNames& series) {
  if (series.size() < 2) return series;
  std::map<std::string, std::size_t> uses;
  for (const std::string& name : series) {
    const std::vector<std::string> parts = PartsOf(name);
    for (const std::string& part : std::set<std::string>(parts.begin(), parts.end())) ++uses[part];
  }
  SeriesNames varying;
  for (const std::string& name : series) {
    std::string own;
    for (const std::string& part : PartsOf(name)) {
      if (uses[part] < series.size()) own += (own.empty() ? "" : ",") + part;
    }
    if (own.empty()) return series;
    varying.push_back(std::move(own));
  }
  return varying;
}

std::string Legend(const SeriesNames& series) {
  if (series.size() == 1 && series[0].empty()) return "";
  const SeriesNames names = WhatVaries(series);
  std::string legend = "<div class=\"legend\">";
  for (std::size_t i = 0; i < series.size(); ++i) {
    legend += fmt::format(
        "<button type=\"button\" aria-pressed=\"true\" data-series=\"n{}\" title=\"{}\"><svg "
        "viewBox=\"-6 -6 12 12\" width=\"12\" height=\"12\">{}</svg>{}</button>",
        i, Escape(series[i]), Marker(static_cast<int>(i), 0, 0, ""), Escape(names[i]));
  }
  // The marks of a legend stand for no run.
  for (std::size_t at; (at = legend.find("class=\"mark ")) != std::string::npos;) {
    legend.replace(at, 12, "class=\"");
  }
  return legend + "</div>";
}

std::string Caption(const ChartText& text) {
  return fmt::format(
      "<figure class=\"chart\" data-title=\"{0}\"><figcaption>{0} <button type=\"button\" "
      "class=\"save\">PNG</button></figcaption>",
      Escape(text.title));
}

}  // namespace

ChartFrame::ChartFrame(const ChartText& text, Axis x, Axis y)
    : text_(text), x_(std::move(x)), y_(std::move(y)) {}

double ChartFrame::X(double value) const {
  return kLeft + x_.Position(value) * (kWidth - kLeft - kRight);
}

double ChartFrame::Y(double value) const {
  return kHeight - kBottom - y_.Position(value) * (kHeight - kTop - kBottom);
}

std::string ChartFrame::Grid() const {
  std::string svg;
  const double bottom = kHeight - kBottom, right = kWidth - kRight;
  for (const Axis::Tick& tick : x_.ticks()) {
    const double x = X(tick.value);
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text class=\"tick\" "
        "x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4}</text>",
        x, kTop, bottom, bottom + 16, tick.label);
  }
  for (const Axis::Tick& tick : y_.ticks()) {
    const double y = Y(tick.value);
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"tick\" "
        "x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>",
        kLeft, y, right, kLeft - 6, y + 4, tick.label);
  }
  svg += fmt::format("<path class=\"axis\" d=\"M{0} {1}V{2}H{3}\"/>", kLeft, kTop, bottom, right);
  svg += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                     (kLeft + right) / 2, kHeight - 8, Escape(x_.label()));
  svg += fmt::format(
      "<text class=\"label\" transform=\"translate(14 {:.1f}) rotate(-90)\" "
      "text-anchor=\"middle\">{}</text>",
      (kTop + bottom) / 2, Escape(y_.label()));
  return svg;
}

std::string ChartFrame::Figure(const SeriesNames& series, const std::string& marks,
                               const std::string& note) const {
  const std::string below = text_.note + (text_.note.empty() || note.empty() ? "" : " ") + note;
  return fmt::format(
      "{}{}<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}{}</svg>{}</figure>\n",
      Caption(text_), Legend(series), kWidth, kHeight, Escape(text_.title), Grid(), marks,
      below.empty() ? "" : "<p class=\"note\">" + Escape(below) + "</p>");
}

std::string EmptyFigure(const ChartText& text, const std::string& reason) {
  return "<p class=\"empty missing\">" + Escape(text.title + ": " + reason) + "</p>\n";
}

std::string MarkClass(int series, const std::string& further) {
  const char* again = series < kColours ? "" : " again";
  return fmt::format("class=\"mark s{}{} n{}{}\"", series % kColours, again, series, further);
}

std::string TitleElement(const std::string& title) {
  return title.empty() ? "" : "<title>" + Escape(title) + "</title>";
}

std::string Marker(int series, double x, double y, const std::string& title,
                   const std::string& link) {
  const double r = kMarkerSize;
  const std::string shapes[kShapes] = {
      fmt::format("a{0} {0} 0 1 0 {1} 0a{0} {0} 0 1 0 -{1} 0z", r, 2 * r),
      fmt::format("v-{0}h{1}v{1}h-{1}z", r * 0.9, 2 * r * 0.9),
      fmt::format("l{0} -{1}l{0} {1}z", r, 1.5 * r), fmt::format("l{0} -{0}l{0} {0}l-{0} {0}z", r)};
  const int shape = (series + series / kColours) % kShapes;  // another one when colours repeat
  const double down = shape == 2 ? y + 0.75 * r : y;
  const std::string mark =
      fmt::format("<path {} d=\"M{:.1f} {:.1f}{}\">{}</path>", MarkClass(series), x - r, down,
                  shapes[shape], TitleElement(title));
  return link.empty() ? mark : fmt::format("<a href=\"{}\">{}</a>", Escape(link), mark);
}

}  // namespace cirque::experiment_report
