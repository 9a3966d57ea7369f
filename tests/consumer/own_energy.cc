// Solves a circle pattern in a Ceres problem of its own; registers and audits an energy of its own.
#include <ceres/ceres.h>

#include "cirque/cirque.h"

struct CoshEnergy final : cirque::Energy {  // E(x) = sum_f cosh(x_f)
  explicit CoshEnergy(const cirque::EnergyInput& in) : n(in.triangulation.num_faces()) {}
  int NumParameters() const override { return n; }
  bool Evaluate(const double* x, double* value, double* gradient) const override {
    const Eigen::Map<const Eigen::ArrayXd> at(x, n);
    *value = at.cosh().sum();
    if (gradient) Eigen::Map<Eigen::ArrayXd>(gradient, n) = at.sinh();
    return AllFinite(x);
  }
  bool Hessian(const double* x, cirque::SparseMatrix* lower) const override {
    *lower = Eigen::VectorXd::Map(x, n).array().cosh().matrix().asDiagonal();
    return AllFinite(x);
  }
  int n;
};

int main() {
  const auto surface = cirque::SurfaceFromTriangles(
      {{2, 0, 0}, {2, 1, 0}, {-1, 2, 0}, {-2, 0, 0}, {0, 0, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}});
  const cirque::Triangulation& t = surface->triangulation;
  const auto angles = cirque::MeasureCornerAngles(t, cirque::MeasureEdgeLengths(*surface)).value;
  Eigen::VectorXd rho = Eigen::VectorXd::Zero(3);
  ceres::Problem problem;
  cirque::CirclePatternEnergy(t, {angles}).AddResidualBlocks(rho.data(), &problem);
  ceres::Solve({}, &problem, std::make_unique<ceres::Solver::Summary>().get());
  // A flat surface is its own circle pattern; halfedges 0 and 4 are the two sides of one edge.
  const double miss = std::exp(rho[0] - rho[1]) - std::sin(angles[4]) / std::sin(angles[0]);
  if (!(std::abs(miss) < 1e-6)) return 1;
  const auto make = [](const cirque::EnergyInput& in) { return std::make_unique<CoshEnergy>(in); };
  const auto registry = cirque::Energies().With("cosh", make);
  const std::shared_ptr<cirque::Energy> energy = (*registry.Find("cosh"))({t});
  const auto findings = cirque::AuditEnergy({{"disk", energy, {{"near 0", rho, 0.1}}, {}}});
  return std::all_of(findings.begin(), findings.end(), [](const auto& f) { return f.ok(); }) ? 0
                                                                                             : 2;
}
