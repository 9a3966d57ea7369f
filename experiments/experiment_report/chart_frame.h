#pragma once

#include <string>
#include <vector>

#include "experiments/experiment_report/axis.h"

namespace cirque::experiment_report {

/// What a chart is called and what its axes are. Charts are HTML figure elements with an inline SVG
/// that takes its colours from the page's style sheet: series i has the class "s" + i mod 8, from
/// the ninth on also "again" (lines are dashed), and points of every series have one of 4 shapes.
/// Every mark has the classes "mark" and "n" with i, and a title for the pointer. The legend names
/// what the series differ in; its buttons hide and show them. A button saves the chart as a PNG.
struct ChartText {
  std::string title;
  std::string x_label, y_label;
  AxisKind x_kind = AxisKind::kLinear, y_kind = AxisKind::kLinear;
  std::string note = {};  ///< below it, plain text
};

/// The names of the series, which marks refer to by position.
using SeriesNames = std::vector<std::string>;

/// The axes, grid and labels of a chart, and the place of a pair of values in it.
class ChartFrame {
 public:
  ChartFrame(const ChartText& text, Axis x, Axis y);

  double X(double value) const;
  double Y(double value) const;
  const Axis& x() const { return x_; }
  const Axis& y() const { return y_; }
  bool Shows(double x, double y) const { return x_.Shows(x) && y_.Shows(y); }

  /// The figure element with the marks inside; `note` follows the one of the text.
  std::string Figure(const SeriesNames& series, const std::string& marks,
                     const std::string& note) const;

 private:
  std::string Grid() const;

  const ChartText& text_;
  Axis x_, y_;
};

/// A line in place of a figure that would be empty.
std::string EmptyFigure(const ChartText& text, const std::string& reason);

/// The class attribute of a series' marks.
std::string MarkClass(int series, const std::string& further = "");
std::string TitleElement(const std::string& title);

/// A point of the series' shape around a place of the frame; with a link a click on it leads there.
std::string Marker(int series, double x, double y, const std::string& title,
                   const std::string& link = "");

}  // namespace cirque::experiment_report
