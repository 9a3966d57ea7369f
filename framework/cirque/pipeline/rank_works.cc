#include "cirque/pipeline/rank_works.h"

#include "cirque/radii/pattern_part.h"

namespace cirque {

const RankWorks& AllRankWorks() {
  static const RankWorks kTable = {
      {kCirclePatternWork, [](Ranks& ranks) { return std::make_unique<PatternPart>(&ranks); }},
      {kDualAngleWork,
       [](Ranks& ranks) {
         return std::make_unique<NewtonPart>(&ranks, EnergyPartMakers().at(kDualAngleWork));
       }},
  };
  return kTable;
}

}  // namespace cirque
