// Every form of every energy on a generated terrain: value and gradient, gradient, Hessian, and the
// residual blocks where the energy has them.
#include <ceres/crs_matrix.h>
#include <ceres/problem.h>

#include "bench/registration.h"
#include "bench/terrain.h"

namespace cirque {
namespace {

struct Subject {
  std::unique_ptr<Energy> energy;
  Eigen::VectorXd x;
};

Subject MakeSubject(const std::string& name, int triangles) {
  const EnergyInput& input = Terrain(triangles);
  Subject subject{(*Energies().Find(name))(input), {}};
  subject.x = Eigen::VectorXd::Zero(subject.energy->NumParameters());
  double value;
  if (!subject.energy->Evaluate(subject.x.data(), &value, nullptr)) {
    subject.x = input.coherent.value;
  }
  return subject;
}

void TimeValueAndGradient(benchmark::State& state, const Subject& subject) {
  Eigen::VectorXd gradient(subject.x.size());
  double value = 0;
  for (auto _ : state) {
    subject.energy->Evaluate(subject.x.data(), &value, gradient.data());
    benchmark::DoNotOptimize(value);
  }
}

void TimeGradient(benchmark::State& state, const Subject& subject) {
  Eigen::VectorXd gradient(subject.x.size());
  for (auto _ : state) subject.energy->Gradient(subject.x.data(), gradient.data());
}

void TimeHessian(benchmark::State& state, const Subject& subject) {
  SparseMatrix lower;
  for (auto _ : state) subject.energy->Hessian(subject.x.data(), &lower);
  state.counters["bytes"] =
      static_cast<double>(lower.nonZeros() * static_cast<int>(sizeof(double) + sizeof(int)));
}

/// Residuals and Jacobian of the whole problem.
void TimeResiduals(benchmark::State& state, const Subject& subject) {
  Eigen::VectorXd x = subject.x;
  ceres::Problem problem;
  subject.energy->AddResidualBlocks(x.data(), &problem);
  std::vector<double> residuals;
  ceres::CRSMatrix jacobian;
  for (auto _ : state) problem.Evaluate({}, nullptr, &residuals, nullptr, &jacobian);
  state.counters["residuals"] = static_cast<double>(residuals.size());
  state.counters["bytes"] = static_cast<double>(jacobian.values.size() * sizeof(double) +
                                                jacobian.cols.size() * sizeof(int));
}

using Timed = void (*)(benchmark::State&, const Subject&);

void Register(const std::string& energy, const std::string& form, Timed time) {
  RegisterBySize(energy + "/" + form, {kLarge}, [=](benchmark::State& state, int triangles) {
    time(state, MakeSubject(energy, triangles));
    CountFaces(state, triangles);
  });
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const std::string& name : Energies().Names()) {
    Register(name, "value_and_gradient", TimeValueAndGradient);
    Register(name, "gradient", TimeGradient);
    Register(name, "hessian", TimeHessian);
    const auto energy = (*Energies().Find(name))(Terrain(100));
    if (energy->residual_form() == ResidualForm::kAbsent) continue;
    Register(name, "residuals", TimeResiduals);
  }
  return true;
}();

}  // namespace
}  // namespace cirque
