#pragma once

#include <string>
#include <vector>

namespace cirque::experiment_report {

enum class AxisKind { kLinear, kWhole, kLogarithmic };  // whole: ticks at whole numbers only

/// One axis of a chart: its range, widened to where the ticks are, and the way onto [0, 1].
class Axis {
 public:
  struct Tick {
    double value = 0;
    std::string label;
  };

  /// Around the values; those that are not finite, or on a logarithmic axis not positive, do not
  /// count.
  Axis(std::string label, AxisKind kind, const std::vector<double>& values);

  bool Shows(double value) const;
  /// 0 at the low end, 1 at the high one.
  double Position(double value) const;
  const std::string& label() const { return label_; }
  const std::vector<Tick>& ticks() const { return ticks_; }
  double low() const { return low_; }
  double high() const { return high_; }
  bool logarithmic() const { return kind_ == AxisKind::kLogarithmic; }

 private:
  void SetLinearTicks();
  void SetLogarithmicTicks();

  std::string label_;
  AxisKind kind_;
  double low_ = 0, high_ = 1;
  std::vector<Tick> ticks_;
};

}  // namespace cirque::experiment_report
