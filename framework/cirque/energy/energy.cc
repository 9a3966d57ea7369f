#include "cirque/energy/energy.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

#include "cirque/energy/parameter_space.h"

namespace cirque {

void Energy::AddResidualBlocks(double*, ceres::Problem*) const {
  LOG(FATAL) << "this energy has no least-squares form; ask residual_form() first";
}

const ParameterSpace& Energy::space() const {
  static const ParameterSpace kOfOneProcess;
  return kOfOneProcess;
}

bool Energy::AllFinite(const double* x) const {
  return std::all_of(x, x + NumParameters(), [](double t) { return std::isfinite(t); });
}

}  // namespace cirque
