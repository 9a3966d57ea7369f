#include "cirque/energy/registry.h"

#include <string>

#include "cirque/energy/barrier_objective.h"
#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/energy/coherent_angle_barrier.h"
#include "cirque/energy/conformal_equivalence_energy.h"
#include "cirque/energy/dual_angle_energy.h"
#include "cirque/energy/entropy_objective.h"
#include "cirque/energy/lorentz_energy.h"
#include "cirque/energy/quadratic_objective.h"

namespace cirque {
namespace {

std::unique_ptr<Energy> MakeCirclePattern(const EnergyInput& input) {
  return std::make_unique<CirclePatternEnergy>(input.triangulation, input.coherent);
}

std::unique_ptr<Energy> MakeCoherentAngleBarrier(const EnergyInput& input) {
  return std::make_unique<CoherentAngleBarrier>(input.triangulation, input.reference,
                                                input.epsilon);
}

std::unique_ptr<Energy> MakeLorentz(const EnergyInput& input) {
  return std::make_unique<LorentzEnergy>(input.points, input.weights);
}

using EquivalenceFlips = ConformalEquivalenceEnergy::Flips;

/// With Ptolemy flips or on the triangulation as it is.
EnergyFactory ConformalEquivalence(EquivalenceFlips flips) {
  return [flips](const EnergyInput& input) -> std::unique_ptr<Energy> {
    return std::make_unique<ConformalEquivalenceEnergy>(input.triangulation,
                                                        input.lengths.value.array().log(),
                                                        TargetsOfScales(input.targets), flips);
  };
}

/// The dual of the angle fit with that objective.
EnergyFactory DualOf(const std::string& objective) {
  return [objective](const EnergyInput& input) -> std::unique_ptr<Energy> {
    return std::make_unique<DualAngleEnergy>(AngleConstraints(input.triangulation, input.targets),
                                             input.reference.value, input.epsilon,
                                             *AngleObjectives().Find(objective));
  };
}

}  // namespace

const Registry<std::shared_ptr<const AngleObjective>>& AngleObjectives() {
  using Kind = QuadraticObjective::Kind;
  static const Registry<std::shared_ptr<const AngleObjective>> kTable(
      "angle objective",
      {
          {"quadratic", std::make_shared<QuadraticObjective>(Kind::kUniform)},
          {"weighted_quadratic", std::make_shared<QuadraticObjective>(Kind::kRelative)},
          {"barrier", std::make_shared<BarrierObjective>()},
          {"entropy", std::make_shared<EntropyObjective>()},
          {"least_squares", std::make_shared<QuadraticObjective>(Kind::kUnbounded)},
      });
  return kTable;
}

const Registry<EnergyFactory>& Energies() {
  static const Registry<EnergyFactory> kTable(
      "energy", {
                    {"circle_pattern", MakeCirclePattern},
                    {"coherent_angle_barrier", MakeCoherentAngleBarrier},
                    {"conformal_equivalence", ConformalEquivalence(EquivalenceFlips::kPtolemy)},
                    {"conformal_equivalence_fixed", ConformalEquivalence(EquivalenceFlips::kNever)},
                    {"lorentz", MakeLorentz},
                    {"quadratic_dual", DualOf("quadratic")},
                    {"weighted_quadratic_dual", DualOf("weighted_quadratic")},
                    {"barrier_dual", DualOf("barrier")},
                    {"entropy_dual", DualOf("entropy")},
                    {"least_squares_dual", DualOf("least_squares")},
                });
  return kTable;
}

}  // namespace cirque
