#include "experiments/experiment_report/axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace cirque::experiment_report {
namespace {

constexpr int kMostTicks = 6;
constexpr double kRounding = 1e-9;  // of a tick's step: what arithmetic may have lost

/// "10" with the exponent raised.
std::string PowerLabel(int exponent) {
  static const std::vector<std::string> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                   "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string label = exponent < 0 ? "10⁻" : "10";
  for (const char digit : fmt::format("{}", std::abs(exponent))) label += kDigits[digit - '0'];
  return label;
}

/// The least of 1, 2, 5 times a power of ten that is not below `step`.
double RoundStep(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step * (1 - kRounding)) return factor * power;
  }
  return 10 * power;
}

/// The ticks between 1 and 10 on an axis over one or two powers of ten.
std::vector<double> BetweenPowers(int powers) {
  return powers == 1 ? std::vector<double>{2, 5} : std::vector<double>{3};
}

std::string PlainLabel(double value, double step) {
  if (std::abs(value) < kRounding * step) return "0";
  return fmt::format("{:.6g}", value);
}

}  // namespace

Axis::Axis(std::string label, AxisKind kind, const std::vector<double>& values)
    : label_(std::move(label)), kind_(kind) {
  std::vector<double> shown;
  std::copy_if(values.begin(), values.end(), std::back_inserter(shown),
               [&](double value) { return Shows(value); });
  if (!shown.empty()) {
    const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
    low_ = *low;
    high_ = *high;
  } else {
    low_ = 1;
    high_ = 10;
  }
  logarithmic() ? SetLogarithmicTicks() : SetLinearTicks();
}

bool Axis::Shows(double value) const {
  return std::isfinite(value) && (!logarithmic() || value > 0);
}

double Axis::Position(double value) const {
  return logarithmic() ? std::log(value / low_) / std::log(high_ / low_)
                       : (value - low_) / (high_ - low_);
}

void Axis::SetLinearTicks() {
  if (!(high_ > low_)) {
    const double margin = std::max(std::abs(low_) * 0.1, 1e-3);
    low_ -= margin;
    high_ += margin;
  }
  double step = RoundStep((high_ - low_) / (kMostTicks - 1));
  if (kind_ == AxisKind::kWhole) step = std::max(step, 1.0);
  const double first = std::floor(low_ / step + kRounding);
  const double last = std::ceil(high_ / step - kRounding);
  low_ = first * step;
  high_ = last * step;
  for (double i = first; i <= last; ++i) ticks_.push_back({i * step, PlainLabel(i * step, step)});
}

void Axis::SetLogarithmicTicks() {
  int first = static_cast<int>(std::floor(std::log10(low_) + kRounding));
  int last = static_cast<int>(std::ceil(std::log10(high_) - kRounding));
  if (first == last) ++last;
  low_ = std::pow(10, first);
  high_ = std::pow(10, last);
  const bool plain = first >= -3 && last <= 5;
  const int step = (last - first + kMostTicks - 1) / kMostTicks;
  for (int exponent = first; exponent <= last; ++exponent) {
    if ((exponent - first) % step != 0) continue;
    const double value = std::pow(10, exponent);
    ticks_.push_back({value, plain ? fmt::format("{:.6g}", value) : PowerLabel(exponent)});
    if (last - first > 2 || exponent == last) continue;
    for (const double factor : BetweenPowers(last - first)) {
      ticks_.push_back({factor * value, plain ? fmt::format("{:.6g}", factor * value) : ""});
    }
  }
}

}  // namespace cirque::experiment_report
