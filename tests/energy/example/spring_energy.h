#pragma once

#include <memory>
#include <vector>

#include "cirque/energy/energy.h"
#include "cirque/energy/registry.h"

namespace cirque {

/// The example of framework/docs/adding-an-energy.md: springs of rest length l_e across the edges of the
/// dual graph, E(x) = sum_int (cosh(x_i - x_j - l_e) - 1), l_e = alpha_i - alpha_j of the
/// reference. Convex, unchanged by a constant (the gauge: parameter 0).
class SpringEnergy final : public Energy {
 public:
  explicit SpringEnergy(const EnergyInput& input);

  int NumParameters() const override { return num_faces_; }
  bool Evaluate(const double* x, double* value, double* gradient) const override;
  bool Hessian(const double* x, SparseMatrix* lower) const override;
  std::vector<int> GaugeParameters() const override { return {0}; }
  ResidualForm residual_form() const override { return ResidualForm::kExact; }
  void AddResidualBlocks(double* x, ceres::Problem* problem) const override;

 private:
  struct Spring {
    int i, j;
    double rest;
  };

  int num_faces_;
  std::vector<Spring> springs_;
};

/// The factory that the registry's line names.
std::unique_ptr<Energy> MakeSpring(const EnergyInput& input);

}  // namespace cirque
