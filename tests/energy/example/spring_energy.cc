#include "tests/energy/example/spring_energy.h"

#include <cmath>

#include <ceres/sized_cost_function.h>

#include "cirque/energy/dual_laplacian.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/math/scalar_jet.h"

namespace cirque {
namespace {

/// The element function, in which alone the formula stands: cosh t - 1 = 1/2 (2 sinh(t/2))^2.
ScalarJet Element(double t) {
  const double half = std::sinh(0.5 * t);
  return {2 * half * half, std::sinh(t), std::cosh(t)};
}

class SpringResidual final : public ceres::SizedCostFunction<1, 1, 1> {
 public:
  explicit SpringResidual(double rest) : rest_(rest) {}

  bool Evaluate(double const* const* x, double* residual, double** jacobians) const override {
    const double half = 0.5 * (x[0][0] - x[1][0] - rest_);
    if (!std::isfinite(std::cosh(half))) return false;
    *residual = 2 * std::sinh(half);
    if (jacobians && jacobians[0]) jacobians[0][0] = std::cosh(half);
    if (jacobians && jacobians[1]) jacobians[1][0] = -std::cosh(half);
    return true;
  }

 private:
  double rest_;
};

}  // namespace

SpringEnergy::SpringEnergy(const EnergyInput& input) : num_faces_(input.triangulation.num_faces()) {
  const Triangulation& t = input.triangulation;
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    if (g == kNone || Triangulation::Face(h) == Triangulation::Face(g)) continue;
    const double rest = input.reference.value[h] - input.reference.value[g];
    springs_.push_back({Triangulation::Face(h), Triangulation::Face(g), rest});
  }
}

bool SpringEnergy::Evaluate(const double* x, double* value, double* gradient) const {
  if (!AllFinite(x)) return false;
  CompensatedSum sum;
  for (int f = 0; gradient && f < num_faces_; ++f) gradient[f] = 0;
  for (const Spring& s : springs_) {
    const ScalarJet jet = Element(x[s.i] - x[s.j] - s.rest);
    sum += jet.value;
    if (!gradient) continue;
    gradient[s.i] += jet.slope;
    gradient[s.j] -= jet.slope;
  }
  *value = sum.Value();
  return std::isfinite(*value);
}

bool SpringEnergy::Hessian(const double* x, SparseMatrix* lower) const {
  if (!AllFinite(x)) return false;
  LaplacianAssembler laplacian(num_faces_, springs_.size());
  for (const Spring& s : springs_) {
    laplacian.Add(s.i, s.j, Element(x[s.i] - x[s.j] - s.rest).curvature);
  }
  laplacian.Assemble(lower);
  return true;
}

void SpringEnergy::AddResidualBlocks(double* x, ceres::Problem* problem) const {
  for (int f = 0; f < num_faces_; ++f) problem->AddParameterBlock(x + f, 1);
  for (const Spring& s : springs_) {
    problem->AddResidualBlock(new SpringResidual(s.rest), nullptr, x + s.i, x + s.j);
  }
  problem->SetParameterBlockConstant(x);
}

std::unique_ptr<Energy> MakeSpring(const EnergyInput& input) {
  return std::make_unique<SpringEnergy>(input);
}

}  // namespace cirque
