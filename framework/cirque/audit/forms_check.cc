// The forms of one energy tell the same: value, gradient, Hessian, residual blocks.
#include <cmath>

#include <ceres/crs_matrix.h>
#include <ceres/problem.h>

#include "cirque/audit/checks.h"

namespace cirque {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The residual blocks of an energy at x, the gauge freed so that every derivative shows.
struct Residuals {
  bool evaluated = false;
  double cost = 0;
  VectorXd values, gradient;
  MatrixXd jacobian;
};

Residuals EvaluateResiduals(const Energy& energy, VectorXd x) {
  ceres::Problem problem;
  energy.AddResidualBlocks(x.data(), &problem);
  ceres::Problem::EvaluateOptions options;
  for (double& parameter : x) {
    problem.AddParameterBlock(&parameter, 1);
    problem.SetParameterBlockVariable(&parameter);
    options.parameter_blocks.push_back(&parameter);
  }
  Residuals result;
  std::vector<double> values, gradient;
  ceres::CRSMatrix jacobian;
  result.evaluated = problem.Evaluate(options, &result.cost, &values, &gradient, &jacobian);
  if (!result.evaluated) return result;
  result.values = Eigen::Map<VectorXd>(values.data(), static_cast<int>(values.size()));
  result.gradient = Eigen::Map<VectorXd>(gradient.data(), static_cast<int>(gradient.size()));
  result.jacobian = MatrixXd::Zero(jacobian.num_rows, jacobian.num_cols);
  for (int row = 0; row < jacobian.num_rows; ++row) {
    for (int k = jacobian.rows[row]; k < jacobian.rows[row + 1]; ++k) {
      result.jacobian(row, jacobian.cols[k]) = jacobian.values[k];
    }
  }
  return result;
}

/// max |a - b| over 1 + max |b|.
double Relative(const MatrixXd& a, const MatrixXd& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return std::nan("");
  return (a - b).lpNorm<Eigen::Infinity>() / (1 + b.lpNorm<Eigen::Infinity>());
}

void CheckGradientForms(const AuditCase& c, const AuditPoint& point, AuditFinding* finding) {
  VectorXd alone(point.x.size()), with_value(point.x.size());
  double value = std::nan("");
  const bool both = c.energy->Evaluate(point.x.data(), &value, with_value.data()) &&
                    c.energy->Gradient(point.x.data(), alone.data());
  finding->Note(both ? Relative(alone, with_value) : std::nan(""),
                c.Where(point, "Gradient() against Evaluate()'s gradient, relative"));
  const double difference = ValueAt(*c.energy, point.x) - value;
  finding->Note(std::abs(difference) / (1 + std::abs(value)),
                c.Where(point, "value without gradient against value with it, relative"));
}

void CheckExactResiduals(const AuditCase& c, const AuditPoint& point, const Residuals& r,
                         double* offset, AuditFinding* finding) {
  const double value = ValueAt(*c.energy, point.x);
  if (std::isnan(*offset)) *offset = value - r.cost;
  const double scale = 1 + std::abs(value) + std::abs(*offset);
  finding->Note(std::abs(value - r.cost - *offset) / scale,
                c.Where(point, "E - 1/2 |r|^2 differs from the first point's, relative"));
  const VectorXd gradient = GradientAt(*c.energy, point.x);
  finding->Note(Relative(r.gradient, gradient), c.Where(point, "J'r against gradient, relative"));
  // The Jacobian by itself, since J'r hides what multiplies a residual that vanishes.
  for (const VectorXd& p : Directions(static_cast<int>(point.x.size()))) {
    const double h = 1e-5 * point.step;
    const Residuals plus = EvaluateResiduals(*c.energy, point.x + h * p);
    const Residuals minus = EvaluateResiduals(*c.energy, point.x - h * p);
    if (!plus.evaluated || !minus.evaluated) {
      finding->Note(std::nan(""), c.Where(point, "residuals refuse a point inside the domain"));
      return;
    }
    const VectorXd slope = (plus.values - minus.values) / (2 * h);
    // Differences have half the digits; they are here to see signs and factors.
    const double error = (slope - r.jacobian * p).lpNorm<Eigen::Infinity>();
    const double scale_of_slope =
        1 + r.jacobian.lpNorm<Eigen::Infinity>() + 1e-8 * r.values.lpNorm<Eigen::Infinity>() / h;
    finding->Note(1e-6 * error / scale_of_slope, c.Where(point, "1e-6 of dr(p) - Jp, relative"));
  }
}

void CheckGradientResiduals(const AuditCase& c, const AuditPoint& point, const Residuals& r,
                            AuditFinding* finding) {
  finding->Note(Relative(r.values, GradientAt(*c.energy, point.x)),
                c.Where(point, "r against gradient, relative"));
  finding->Note(Relative(r.jacobian, HessianAt(*c.energy, point.x)),
                c.Where(point, "J against Hessian, relative"));
}

}  // namespace

void CheckForms(const AuditCase& c, AuditFinding* finding) {
  double offset = std::nan("");
  for (const AuditPoint& point : c.inside) {
    CheckGradientForms(c, point, finding);
    if (c.energy->residual_form() == ResidualForm::kAbsent) continue;
    const Residuals r = EvaluateResiduals(*c.energy, point.x);
    if (!r.evaluated) {
      finding->Note(std::nan(""), c.Where(point, "residuals refuse a point inside the domain"));
    } else if (c.energy->residual_form() == ResidualForm::kExact) {
      CheckExactResiduals(c, point, r, &offset, finding);
    } else {
      CheckGradientResiduals(c, point, r, finding);
    }
  }
}

}  // namespace cirque
