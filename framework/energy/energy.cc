#include "cirque/energy/energy.h"

#include <glog/logging.h>

namespace cirque {

void Energy::AddResidualBlocks(double*, ceres::Problem*) const {
  LOG(FATAL) << "this energy has no least-squares form; ask HasExactResiduals() first";
}

}  // namespace cirque
