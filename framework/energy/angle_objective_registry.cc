#include "cirque/energy/angle_objective.h"
#include "cirque/energy/quadratic_objective.h"

namespace cirque {

const Registry<std::shared_ptr<const AngleObjective>>& AngleObjectives() {
  static const Registry<std::shared_ptr<const AngleObjective>> table(
      "angle objective", {
                             {"quadratic", std::make_shared<QuadraticObjective>()},
                         });
  return table;
}

}  // namespace cirque
