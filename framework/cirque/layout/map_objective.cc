#include "cirque/layout/map_objective.h"

#include <algorithm>
#include <cmath>

namespace cirque {
namespace {

double MipsValue(double m) { return 4 * m * m / ((1 - m) * (1 + m)); }

double MipsWeight(double m) {
  const double rest = (1 - m) * (1 + m);
  return 8 / (rest * rest);
}

constexpr double kRounding = 1e-4;  ///< below it the kink at m = 0 is a parabola's vertex

double QuasiConformalWeight(double m) { return 2 / ((1 - m) * (1 - m) * std::max(m, kRounding)); }

/// The integral of m times the weight: 2 m / (1 - m) and a constant, from the rounding on; below it
/// 2 / kRounding (m / (1 - m) + log(1 - m)) by its series.
double QuasiConformalValue(double m) {
  const auto rounded = [](double x) {
    return 2 / kRounding * x * x * (1.0 / 2 + x * (2.0 / 3 + x * 3.0 / 4));
  };
  if (m < kRounding) return rounded(m);
  return 2 * m / (1 - m) - 2 * kRounding / (1 - kRounding) + rounded(kRounding);
}

}  // namespace

const Registry<MapObjective>& MapObjectives() {
  static const Registry<MapObjective> kTable(
      "map objective", {{"mips", {MipsValue, MipsWeight}},
                        {"quasi_conformal", {QuasiConformalValue, QuasiConformalWeight}}});
  return kTable;
}

}  // namespace cirque
