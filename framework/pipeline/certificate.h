#pragma once

#include <map>
#include <string>

#include "cirque/core/infeasibility.h"

namespace cirque {

/// The evidence a run leaves behind. Quantities that a run did not come to are NaN and written as
/// null.
struct Certificate {
  std::string outcome = "not_run";  ///< ToString(StatusCode)
  std::string message;              ///< why, when the outcome is not ok
  std::map<std::string, double>
      values;  ///< by the names in certificate.cc, SI-free: radians, or relative
  std::map<std::string, double> seconds;  ///< wall time by stage
  InfeasibilityProof infeasibility;

  std::string ToJson() const;
};

}  // namespace cirque
