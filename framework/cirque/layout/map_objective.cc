#include "cirque/layout/map_objective.h"

#include <algorithm>
#include <cmath>

namespace cirque {
namespace {

double MipsValue(double m_squared) { return 4 * m_squared / (1 - m_squared); }

double MipsWeight(double m_squared) { return 8 / ((1 - m_squared) * (1 - m_squared)); }

constexpr double kRounding = 1e-4;  ///< below it the kink at m = 0 is a parabola's vertex

double QuasiConformalWeight(double m_squared) {
  const double m = std::sqrt(m_squared);
  return 2 / ((1 - m) * (1 - m) * std::max(m, kRounding));
}

/// The integral of m times the weight: 2 m / (1 - m) and a constant, from the rounding on; below it
/// 2 / kRounding (m / (1 - m) + log(1 - m)) by its series.
double QuasiConformalValue(double m_squared) {
  const auto rounded = [](double x) {
    return 2 / kRounding * x * x * (1.0 / 2 + x * (2.0 / 3 + x * 3.0 / 4));
  };
  const double m = std::sqrt(m_squared);
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
