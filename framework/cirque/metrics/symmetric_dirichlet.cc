#include "cirque/metrics/symmetric_dirichlet.h"

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  const Eigen::ArrayXd s = faces.sigma_max.array().square(), t = faces.sigma_min.array().square();
  const Eigen::VectorXd energy = 0.5 * (s + t + s.inverse() + t.inverse());
  return {energy, {AreaMean(faces.area, energy), Largest(energy)}};
}

}  // namespace

DistortionMeasure SymmetricDirichlet() {
  return {"lengths",
          "(s^2 + t^2 + 1/s^2 + 1/t^2) / 2",
          2,
          10,
          {{"symmetric_dirichlet", "mean of (s^2 + t^2 + 1/s^2 + 1/t^2) / 2, least 2"},
           {"symmetric_dirichlet_max", "its maximum"}},
          Measure};
}

}  // namespace cirque
