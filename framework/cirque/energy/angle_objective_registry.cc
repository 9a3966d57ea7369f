#include "cirque/energy/angle_objective.h"
#include "cirque/energy/barrier_objective.h"
#include "cirque/energy/quadratic_and_entropy_objectives.h"

namespace cirque {

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

}  // namespace cirque
