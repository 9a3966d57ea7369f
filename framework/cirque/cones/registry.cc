#include "cirque/cones/registry.h"

#include "cirque/cones/curvature_peaks.h"
#include "cirque/cones/fixed_cones.h"
#include "cirque/cones/greedy_cones.h"
#include "cirque/cones/l1_cones.h"
#include "cirque/cones/moving_cones.h"
#include "cirque/cones/reweighted_cones.h"

namespace cirque {
namespace {

using Made = StatusOr<std::shared_ptr<const ConeHeuristic>>;

struct NoOptions {};

Made MakeNone(const OptionMap& map) {
  NoOptions options;
  if (Status s = OptionTable<NoOptions>("none", {}).Set(map, &options); !s.ok()) return s;
  return std::shared_ptr<const ConeHeuristic>(std::make_shared<NoCones>());
}

}  // namespace

const Registry<ConeHeuristicFactory>& ConeHeuristics() {
  static const Registry<ConeHeuristicFactory> kTable(
      "cone heuristic",
      {
          {"none", MakeNone},
          {"given", HeuristicFactory<GivenCones>(GivenOptionTable())},
          {"curvature_peaks", HeuristicFactory<CurvaturePeaks>(CurvaturePeaksOptionTable())},
          {"greedy", HeuristicFactory<GreedyCones>(GreedyOptionTable())},
          {"l1", HeuristicFactory<L1Cones>(L1OptionTable())},
          {"reweighted", HeuristicFactory<ReweightedCones>(ReweightedOptionTable())},
          {"moving", MovingCones::Make},
      });
  return kTable;
}

Made MakeConeHeuristic(const std::string& name, const OptionMap& options) {
  const auto factory = ConeHeuristics().Find(name);
  if (!factory.ok()) return factory.status();
  return (*factory)(options);
}

}  // namespace cirque
