#include "cirque/energy/energy_parts.h"

#include <glog/logging.h>

#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/energy/dual_angle_energy.h"

namespace cirque {
namespace {

std::unique_ptr<Energy> MakeCirclePattern(const Triangulation& t, const EnergyData& data) {
  return std::make_unique<CirclePatternEnergy>(t, CoherentAngles{data.angles});
}

std::unique_ptr<Energy> MakeDualAngles(const Triangulation& t, const EnergyData& data) {
  const auto objective = AngleObjectives().Find(data.objective);
  CHECK(objective.ok()) << objective.status().message();
  return std::make_unique<DualAngleEnergy>(AngleConstraints(t, {data.lower, data.upper}),
                                           data.angles, data.epsilon, *objective);
}

}  // namespace

const std::map<std::string, EnergyPartMaker>& EnergyPartMakers() {
  static const std::map<std::string, EnergyPartMaker> kTable = {
      {kCirclePatternWork, MakeCirclePattern},
      {kDualAngleWork, MakeDualAngles},
  };
  return kTable;
}

}  // namespace cirque
