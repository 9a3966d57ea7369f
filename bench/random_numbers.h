#pragma once

#include <random>
#include <vector>

namespace cirque {

/// The same ones at every call.
inline std::vector<double> RandomNumbers(int count, double lower, double upper) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(lower, upper);
  std::vector<double> x(count);
  for (double& value : x) value = uniform(random);
  return x;
}

}  // namespace cirque
