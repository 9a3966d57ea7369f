#pragma once

#include <string>
#include <vector>

namespace cirque::experiment_report {

/// One timed attempt; `seconds` is infinite where it failed.
struct Attempt {
  std::string problem, method;
  double seconds = 0;
};

/// How often a method comes within a factor of the fastest one.
struct Profile {
  std::string method;
  std::vector<double> ratios;  ///< of the problems it solved, increasing: time over the best time
};

struct Profiles {
  std::vector<Profile> methods;  ///< by name
  int problems = 0;              ///< that count
};

/// Performance profiles (E. Dolan, J. Moré, Benchmarking optimization software with performance
/// profiles, Math. Programming 91, 2002): rho(tau) = share of problems with ratio <= tau. Only
/// problems that every method attempted and one of them solved count. Of several attempts of one
/// method on a problem the median time counts, and no failure is allowed.
Profiles PerformanceProfiles(const std::vector<Attempt>& attempts);

}  // namespace cirque::experiment_report
