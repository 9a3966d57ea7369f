#include "cirque/metrics/statistics.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

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

double AreaPercentile(const Eigen::VectorXd& area, const Eigen::VectorXd& values, double fraction) {
  if (values.size() == 0) return kNothing;
  std::vector<Eigen::Index> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return values[i] < values[j]; });
  const double wanted = fraction * area.sum();
  double below = 0;
  for (const Eigen::Index i : order) {
    below += area[i];
    if (below >= wanted) return values[i];
  }
  return values[order.back()];
}

}  // namespace cirque
