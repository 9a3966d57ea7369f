#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <ceres/cost_function.h>
#include <ceres/sized_cost_function.h>

#include "cirque/angles/augmented_lagrangian_angle_solver.h"

namespace cirque {
namespace {

bool Finish(const ResidualJet& r, double sign, int parameters, double* residual,
            double** jacobians) {
  *residual = r.value;
  for (int i = 0; jacobians && i < parameters; ++i) {
    if (jacobians[i]) jacobians[i][0] = sign * r.slope;
  }
  return std::isfinite(r.value) && std::isfinite(r.slope);
}

/// The objective at one corner; false where its angle has none.
class CornerResidual final : public ceres::SizedCostFunction<1, 1> {
 public:
  CornerResidual(const AngleObjective& objective, double reference)
      : objective_(objective), reference_(reference) {}

  bool Evaluate(const double* const* x, double* residual, double** jacobians) const override {
    return Finish(objective_.Residual(reference_, x[0][0]), 1, 1, residual, jacobians);
  }

 private:
  const AngleObjective& objective_;
  const double reference_;
};

/// The objective at the intersection angle pi - (sum of the N angles opposite the edge).
template <int... kOnes>
class ThetaResidual final : public ceres::SizedCostFunction<1, kOnes...> {
 public:
  ThetaResidual(const AngleObjective& objective, double reference)
      : objective_(objective), reference_(reference) {}

  bool Evaluate(const double* const* x, double* residual, double** jacobians) const override {
    constexpr int kAngles = sizeof...(kOnes);
    double theta = kPi;
    for (int i = 0; i < kAngles; ++i) theta -= x[i][0];
    if (!(theta > 0)) return false;
    return Finish(objective_.Residual(reference_, theta), -1, kAngles, residual, jacobians);
  }

 private:
  const AngleObjective& objective_;
  const double reference_;
};

/// sqrt(rho) SignedDistance(sum of the angles - y / rho; lower, upper) of one row of A.
class RowResidual final : public ceres::CostFunction {
 public:
  RowResidual(const AngleConstraints& constraints, int row, int num_angles,
              const AugmentedState& state)
      : lower_(constraints.Lower(row)), upper_(constraints.Upper(row)), row_(row), state_(state) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->assign(num_angles, 1);
  }

  bool Evaluate(const double* const* x, double* residual, double** jacobians) const override {
    const auto angles = static_cast<int>(parameter_block_sizes().size());
    const double root = std::sqrt(state_.penalty);
    double sum = -state_.y[row_] / state_.penalty;
    for (int i = 0; i < angles; ++i) sum += x[i][0];
    const double distance = SignedDistance(sum, lower_, upper_);
    // On the fixed row's only point the distance is still the linear function around it.
    const double slope = distance != 0 || lower_ == upper_ ? root : 0;
    return Finish({root * distance, slope}, 1, angles, residual, jacobians);
  }

 private:
  const double lower_, upper_;
  const int row_;
  const AugmentedState& state_;
};

/// sqrt(rho) max(0, sign (sum of the angles - limit) + multiplier / rho) of one inequality.
template <int... kOnes>
class LimitResidual final : public ceres::SizedCostFunction<1, kOnes...> {
 public:
  LimitResidual(double sign, double limit, const double& multiplier, const AugmentedState& state)
      : sign_(sign), limit_(limit), multiplier_(multiplier), state_(state) {}

  bool Evaluate(const double* const* x, double* residual, double** jacobians) const override {
    constexpr int kAngles = sizeof...(kOnes);
    double sum = 0;
    for (int i = 0; i < kAngles; ++i) sum += x[i][0];
    const double root = std::sqrt(state_.penalty);
    const double excess = sign_ * (sum - limit_) + multiplier_ / state_.penalty;
    const ResidualJet r = excess > 0 ? ResidualJet{root * excess, root} : ResidualJet{};
    return Finish(r, sign_, kAngles, residual, jacobians);
  }

 private:
  const double sign_, limit_;
  const double& multiplier_;
  const AugmentedState& state_;
};

/// Adds blocks edge by edge and row by row.
class Builder {
 public:
  Builder(const AngleFitProblem& fit, const AngleObjective& objective, const AugmentedState& state,
          double* alpha, ceres::Problem* problem)
      : fit_(fit),
        t_(fit.constraints.triangulation()),
        objective_(objective),
        state_(state),
        alpha_(alpha),
        problem_(*problem) {}

  void AddCorner(Index h) {
    problem_.AddParameterBlock(&alpha_[h], 1);
    problem_.AddResidualBlock(new CornerResidual(objective_, Clamped(fit_.reference[h])), nullptr,
                              &alpha_[h]);
    const EdgeMargins margins = MarginsOf(fit_, objective_, h);
    if (!(margins.l > 0)) return;
    problem_.AddResidualBlock(new LimitResidual<1>(-1, margins.l, state_.of_lower[h], state_),
                              nullptr, &alpha_[h]);
  }

  void AddEdge(Index e) {
    const Index l = t_.edge_halfedge[e], r = t_.twin[l];
    if (r == kNone) {
      AddToEdge<1>(e, kPi - fit_.reference[l], &alpha_[l]);
    } else {
      AddToEdge<1, 1>(e, kPi - fit_.reference[l] - fit_.reference[r], &alpha_[l], &alpha_[r]);
    }
  }

  void AddRows() {
    std::vector<std::vector<double*>> angles(fit_.constraints.num_rows());
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      angles[Triangulation::Face(h)].push_back(&alpha_[h]);
      const int row = fit_.constraints.VertexRow(h);
      if (row != kNone) angles[row].push_back(&alpha_[h]);
    }
    for (int row = 0; row < fit_.constraints.num_rows(); ++row) {
      const auto count = static_cast<int>(angles[row].size());
      problem_.AddResidualBlock(new RowResidual(fit_.constraints, row, count, state_), nullptr,
                                angles[row]);
    }
  }

 private:
  /// What concerns the intersection angle.
  template <int... kOnes, class... Angles>
  void AddToEdge(Index e, double theta_reference, Angles... angles) {
    if (objective_.MeasuresTheta()) {
      problem_.AddResidualBlock(new ThetaResidual<kOnes...>(objective_, Clamped(theta_reference)),
                                nullptr, angles...);
    }
    const double margin = MarginsOf(fit_, objective_, t_.edge_halfedge[e]).theta;
    if (!(margin > 0)) return;
    problem_.AddResidualBlock(
        new LimitResidual<kOnes...>(1, kPi - margin, state_.of_sums[e], state_), nullptr,
        angles...);
  }

  double Clamped(double reference) const {
    return objective_.ClampReference(reference, fit_.epsilon);
  }

  const AngleFitProblem& fit_;
  const Triangulation& t_;
  const AngleObjective& objective_;
  const AugmentedState& state_;
  double* alpha_;
  ceres::Problem& problem_;
};

}  // namespace

double SignedDistance(double v, double lower, double upper) {
  return v < lower ? v - lower : (v > upper ? v - upper : 0);
}

void AddAngleResiduals(const AngleFitProblem& fit, const AngleObjective& objective,
                       const AugmentedState& state, double* alpha, ceres::Problem* problem) {
  const Triangulation& t = fit.constraints.triangulation();
  Builder builder(fit, objective, state, alpha, problem);
  for (Index h = 0; h < t.num_halfedges(); ++h) builder.AddCorner(h);
  for (Index e = 0; e < t.num_edges(); ++e) builder.AddEdge(e);
  builder.AddRows();
}

}  // namespace cirque
