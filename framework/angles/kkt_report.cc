#include "cirque/angles/kkt_report.h"

#include <algorithm>
#include <cmath>

namespace cirque {

double KktReport::RelativeGap() const { return std::abs(primal - dual) / (1 + std::abs(primal)); }

KktReport CheckFeasibility(const AngleConstraints& constraints, const Eigen::VectorXd& alpha) {
  const Triangulation& t = constraints.triangulation();
  KktReport report;
  const Eigen::VectorXd sums = constraints.Apply(alpha);
  report.triangle_sum_residual = report.vertex_sum_residual = 0;
  for (int row = 0; row < constraints.num_rows(); ++row) {
    const double outside =
        std::max({0.0, constraints.Lower(row) - sums[row], sums[row] - constraints.Upper(row)});
    double& residual =
        row < constraints.num_faces() ? report.triangle_sum_residual : report.vertex_sum_residual;
    residual = std::max(residual, outside);
  }
  report.smallest_angle = alpha.minCoeff();
  report.smallest_theta = kPi;
  for (const Index h : t.edge_halfedge) {
    const double opposite = t.twin[h] == kNone ? 0 : alpha[t.twin[h]];
    report.smallest_theta = std::min(report.smallest_theta, kPi - alpha[h] - opposite);
  }
  return report;
}

}  // namespace cirque
