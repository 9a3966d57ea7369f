#include "experiments/run_experiment/config/energy_figures.h"

namespace cirque {
namespace {

using Of = const EnergyOutcome&;

}  // namespace

const std::vector<EnergyFigure>& EnergyFigures() {
  static const std::vector<EnergyFigure> kTable = {
      {"energy_parameters", "parameters of the energy", [](Of of) { return of.parameters; }},
      {"energy_iterations", "iterations of the energy's solve",
       [](Of of) { return of.solve.num_iterations(); }},
      {"energy_factorizations", "factorizations of the energy's solve",
       [](Of of) { return of.solve.factorizations; }},
      {"energy_cg_iterations", "conjugate-gradient steps of the energy's solve",
       [](Of of) { return of.solve.cg_iterations; }},
      {"energy_evaluations", "evaluations of the energy",
       [](Of of) { return of.solve.value_evaluations; }},
      {"energy_value", "value of the energy", [](Of of) { return of.solve.final_value; }},
      {"energy_gradient", "largest gradient entry of the energy",
       [](Of of) { return of.solve.final_gradient_max; }},
      {"energy_difference", "largest difference from newton's minimiser",
       [](Of of) { return of.difference; }},
  };
  return kTable;
}

}  // namespace cirque
