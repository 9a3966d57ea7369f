// The forms of every energy on a generated terrain.
#include <benchmark/benchmark.h>

#include "bench/terrain.h"

namespace cirque {
namespace {

constexpr int kTriangles = 20000;

struct Subject {
  std::unique_ptr<Energy> energy;
  Eigen::VectorXd x;
};

Subject MakeSubject(const std::string& name) {
  const EnergyInput& input = Terrain(kTriangles);
  Subject subject{(*Energies().Find(name))(input), {}};
  subject.x = Eigen::VectorXd::Zero(subject.energy->NumParameters());
  double value;
  if (!subject.energy->Evaluate(subject.x.data(), &value, nullptr)) {
    subject.x = input.coherent.value;
  }
  return subject;
}

void TimeValueAndGradient(benchmark::State& state, const std::string& name) {
  const Subject subject = MakeSubject(name);
  Eigen::VectorXd gradient(subject.x.size());
  double value = 0;
  for (auto _ : state) {
    subject.energy->Evaluate(subject.x.data(), &value, gradient.data());
    benchmark::DoNotOptimize(value);
  }
  state.SetItemsProcessed(state.iterations() * kTriangles);
}

void TimeGradient(benchmark::State& state, const std::string& name) {
  const Subject subject = MakeSubject(name);
  Eigen::VectorXd gradient(subject.x.size());
  for (auto _ : state) subject.energy->Gradient(subject.x.data(), gradient.data());
  state.SetItemsProcessed(state.iterations() * kTriangles);
}

void TimeHessian(benchmark::State& state, const std::string& name) {
  const Subject subject = MakeSubject(name);
  SparseMatrix lower;
  for (auto _ : state) subject.energy->Hessian(subject.x.data(), &lower);
  state.SetItemsProcessed(state.iterations() * kTriangles);
}

[[maybe_unused]] const bool kRegistered = [] {
  const auto add = [](const std::string& name, const std::string& form,
                      void (*time)(benchmark::State&, const std::string&)) {
    benchmark::RegisterBenchmark((name + "/" + form).c_str(), [name,
                                                               time](benchmark::State& state) {
      time(state, name);
    })->Unit(benchmark::kMicrosecond);
  };
  for (const std::string& name : Energies().Names()) {
    add(name, "value_and_gradient", TimeValueAndGradient);
    add(name, "gradient", TimeGradient);
    add(name, "hessian", TimeHessian);
  }
  return true;
}();

}  // namespace
}  // namespace cirque
