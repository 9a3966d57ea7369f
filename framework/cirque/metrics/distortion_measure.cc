#include "cirque/metrics/distortion_measure.h"

#include <limits>
#include <utility>

#include "cirque/core/sort_keys.h"

namespace cirque {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double Smallest(const Eigen::VectorXd& values) {
  return values.size() == 0 ? kNothing : values.minCoeff();
}

double Largest(const Eigen::VectorXd& values) {
  return values.size() == 0 ? kNothing : values.maxCoeff();
}

double AreaMean(const Eigen::VectorXd& area, const Eigen::VectorXd& values) {
  return values.size() == 0 ? kNothing : area.dot(values);
}

std::vector<double> AreaPercentiles(const Eigen::VectorXd& area, const Eigen::VectorXd& values,
                                    const std::vector<double>& fractions) {
  if (values.size() == 0) return std::vector<double>(fractions.size(), kNothing);
  std::vector<std::pair<double, int>> order(values.size());
  for (int i = 0; i < values.size(); ++i) order[i] = {values[i], i};
  SortKeys(&order);
  const double total = area.sum();
  std::vector<double> percentiles;
  double below = 0;
  auto next = order.begin();
  for (const double fraction : fractions) {
    for (; next != order.end() - 1 && below + area[next->second] < fraction * total; ++next) {
      below += area[next->second];
    }
    percentiles.push_back(next->first);
  }
  return percentiles;
}

}  // namespace cirque
