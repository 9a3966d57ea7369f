#include "cirque/energy/lorentz_energy.h"

#include <cmath>

#include <ceres/sized_cost_function.h>
#include <glog/logging.h>

#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// 1 - a.b with the error of its last rounding alone: what vanishes where x meets v or the sphere.
double OneMinusDot(const Vector3d& a, const Vector3d& b) {
  CompensatedSum sum;
  sum += 1;
  for (int k = 0; k < 3; ++k) {
    const double product = a[k] * b[k];
    sum -= product;
    sum -= std::fma(a[k], b[k], -product);
  }
  return sum.Value();
}

/// log(1 - a.b), relatively accurate for small a.b too.
double LogOneMinusDot(const Vector3d& a, const Vector3d& b, double one_minus_dot) {
  return one_minus_dot > 0.5 ? std::log1p(-a.dot(b)) : std::log(one_minus_dot);
}

bool IsInside(const Vector3d& x) { return x.allFinite() && OneMinusDot(x, x) > 0; }

/// The gradient of the energy as residuals, the Hessian as their Jacobian.
class LorentzResidual final : public ceres::SizedCostFunction<3, 1, 1, 1> {
 public:
  explicit LorentzResidual(const LorentzEnergy& energy) : energy_(energy) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Vector3d x(parameters[0][0], parameters[1][0], parameters[2][0]);
    if (!IsInside(x)) return false;
    const LorentzJet jet = energy_.Jet(x);
    Map<Vector3d>(residuals, 3) = jet.slope;
    for (int k = 0; jacobians && k < 3; ++k) {
      if (jacobians[k]) Map<Vector3d>(jacobians[k], 3) = jet.curvature.col(k);
    }
    return true;
  }

 private:
  const LorentzEnergy& energy_;
};

}  // namespace

LorentzJet LorentzElement(const Vector3d& v, const Vector3d& x) {
  const double a = OneMinusDot(v, x), b = OneMinusDot(x, x);
  // v = x + u; u is exact where v and x are near, and the large multiples of x cancel on paper.
  const Vector3d u = v - x;
  LorentzJet jet;
  jet.value = LogOneMinusDot(v, x, a) - 0.5 * LogOneMinusDot(x, x, b);
  jet.slope = -(u + (x.dot(u) / b) * x) / a;
  const double xx = (2 * a * a - b * b) / (a * a * b * b);
  jet.curvature = Matrix3d::Identity() / b + xx * (x * x.transpose()) -
                  (x * u.transpose() + u * x.transpose() + u * u.transpose()) / (a * a);
  return jet;
}

LorentzEnergy::LorentzEnergy(const std::vector<Vector3d>& points,
                             const std::vector<double>& weights)
    : points_(points), weights_(weights) {
  CHECK_EQ(points_.size(), weights_.size());
}

LorentzJet LorentzEnergy::Jet(const Vector3d& x) const {
  CompensatedSum value;
  LorentzJet sum;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const LorentzJet jet = LorentzElement(points_[i], x);
    value += weights_[i] * jet.value;
    sum.slope += weights_[i] * jet.slope;
    sum.curvature += weights_[i] * jet.curvature;
  }
  sum.value = value.Value();
  return sum;
}

bool LorentzEnergy::Evaluate(const double* x, double* value, double* gradient) const {
  const Vector3d at(x);
  if (!IsInside(at)) return false;
  const LorentzJet jet = Jet(at);
  *value = jet.value;
  if (gradient) Map<Vector3d>(gradient, 3) = jet.slope;
  return std::isfinite(jet.value);
}

bool LorentzEnergy::Hessian(const double* x, SparseMatrix* lower) const {
  const Vector3d at(x);
  if (!IsInside(at)) return false;
  const Matrix3d curvature = Jet(at).curvature;
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < 3; ++j) {
    for (int i = j; i < 3; ++i) entries.emplace_back(i, j, curvature(i, j));
  }
  lower->resize(3, 3);
  lower->setFromTriplets(entries.begin(), entries.end());
  return true;
}

void LorentzEnergy::AddResidualBlocks(double* x, ceres::Problem* problem) const {
  problem->AddResidualBlock(new LorentzResidual(*this), nullptr, x, x + 1, x + 2);
}

}  // namespace cirque
