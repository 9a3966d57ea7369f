#include "cirque/energy/coherent_angle_barrier.h"

#include <algorithm>
#include <cmath>

#include <ceres/sized_cost_function.h>

#include "cirque/energy/barrier_objective.h"
#include "cirque/math/circle_angle.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

/// theta at two corners (of a boundary edge: 0 for the missing one), accurate where it is tiny.
double ThetaOf(double alpha_l, double alpha_r) {
  return CircleAngle::FromCorners(alpha_l, alpha_r).theta;
}

class CornerResidual final : public ceres::SizedCostFunction<1, 1> {
 public:
  CornerResidual(std::shared_ptr<const AngleObjective> objective, double reference)
      : objective_(std::move(objective)), reference_(reference) {}

  bool Evaluate(double const* const* alpha, double* residual, double** jacobians) const override {
    if (!(alpha[0][0] > 0 && std::isfinite(alpha[0][0]))) return false;
    const ResidualJet r = objective_->Residual(reference_, alpha[0][0]);
    *residual = r.value;
    if (jacobians && jacobians[0]) jacobians[0][0] = r.slope;
    return true;
  }

 private:
  std::shared_ptr<const AngleObjective> objective_;
  double reference_;
};

/// The residual of theta in N = 2 corners, or 1 on the boundary.
template <int... kOnes>
class ThetaResidual final : public ceres::SizedCostFunction<1, kOnes...> {
 public:
  ThetaResidual(std::shared_ptr<const AngleObjective> objective, double reference)
      : objective_(std::move(objective)), reference_(reference) {}

  bool Evaluate(double const* const* alpha, double* residual, double** jacobians) const override {
    constexpr int kCorners = sizeof...(kOnes);
    const double theta = ThetaOf(alpha[0][0], kCorners == 2 ? alpha[kCorners - 1][0] : 0);
    if (!(theta > 0 && std::isfinite(theta))) return false;
    const ResidualJet r = objective_->Residual(reference_, theta);
    *residual = r.value;
    for (int k = 0; jacobians && k < kCorners; ++k) {
      if (jacobians[k]) jacobians[k][0] = -r.slope;
    }
    return true;
  }

 private:
  std::shared_ptr<const AngleObjective> objective_;
  double reference_;
};

}  // namespace

CoherentAngleBarrier::CoherentAngleBarrier(const Triangulation& t, const CornerAngles& reference,
                                           double epsilon)
    : objective_(std::make_shared<BarrierObjective>()), reference_(reference.value) {
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    const double theta = ThetaOf(reference_[h], g == kNone ? 0 : reference_[g]);
    edges_.push_back({h, g, Clamp(theta, epsilon)});
  }
  for (double& alpha : reference_) alpha = Clamp(alpha, epsilon);
}

double CoherentAngleBarrier::Clamp(double reference, double epsilon) {
  const double clamped = objective_->ClampReference(reference, epsilon);
  if (clamped != reference) ++num_clamped_;
  return clamped;
}

double CoherentAngleBarrier::Theta(const Edge& edge, const double* alpha) const {
  return ThetaOf(alpha[edge.l], edge.r == kNone ? 0 : alpha[edge.r]);
}

bool CoherentAngleBarrier::IsInside(const double* alpha) const {
  return AllFinite(alpha) &&
         std::all_of(alpha, alpha + NumParameters(), [](double a) { return a > 0; }) &&
         std::all_of(edges_.begin(), edges_.end(),
                     [&](const Edge& e) { return Theta(e, alpha) > 0; });
}

bool CoherentAngleBarrier::Evaluate(const double* alpha, double* value, double* gradient) const {
  if (!IsInside(alpha)) return false;
  CompensatedSum sum;
  for (int h = 0; h < NumParameters(); ++h) {
    const ScalarJet jet = objective_->Distance(reference_[h], alpha[h]);
    sum += jet.value;
    if (gradient) gradient[h] = jet.slope;
  }
  for (const Edge& e : edges_) {
    const ScalarJet jet = objective_->Distance(e.reference, Theta(e, alpha));
    sum += jet.value;
    if (gradient) gradient[e.l] -= jet.slope;
    if (gradient && e.r != kNone) gradient[e.r] -= jet.slope;
  }
  *value = sum.Value();
  return std::isfinite(*value);
}

bool CoherentAngleBarrier::Hessian(const double* alpha, SparseMatrix* lower) const {
  if (!IsInside(alpha)) return false;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(NumParameters() + 3 * edges_.size());
  for (int h = 0; h < NumParameters(); ++h) {
    entries.emplace_back(h, h, objective_->Distance(reference_[h], alpha[h]).curvature);
  }
  for (const Edge& e : edges_) {
    const double curvature = objective_->Distance(e.reference, Theta(e, alpha)).curvature;
    entries.emplace_back(e.l, e.l, curvature);
    if (e.r == kNone) continue;
    entries.emplace_back(e.r, e.r, curvature);
    entries.emplace_back(std::max(e.l, e.r), std::min(e.l, e.r), curvature);
  }
  lower->resize(NumParameters(), NumParameters());
  lower->setFromTriplets(entries.begin(), entries.end());
  return true;
}

void CoherentAngleBarrier::AddResidualBlocks(double* alpha, ceres::Problem* problem) const {
  for (int h = 0; h < NumParameters(); ++h) {
    problem->AddResidualBlock(new CornerResidual(objective_, reference_[h]), nullptr, alpha + h);
  }
  for (const Edge& e : edges_) {
    if (e.r == kNone) {
      problem->AddResidualBlock(new ThetaResidual<1>(objective_, e.reference), nullptr,
                                alpha + e.l);
    } else {
      problem->AddResidualBlock(new ThetaResidual<1, 1>(objective_, e.reference), nullptr,
                                alpha + e.l, alpha + e.r);
    }
  }
}

}  // namespace cirque
