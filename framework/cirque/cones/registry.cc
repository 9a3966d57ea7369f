#include "cirque/cones/registry.h"

#include <utility>

#include "cirque/cones/curvature_peaks.h"
#include "cirque/cones/given_file.h"
#include "cirque/cones/greedy_cones.h"
#include "cirque/cones/moving_cones.h"
#include "cirque/cones/seamless_cones.h"
#include "cirque/cones/sparse_cones.h"
#include "cirque/core/option.h"

namespace cirque {
namespace {

class NoCones final : public ConeHeuristic {
 public:
  explicit NoCones(NoOptions /*options*/) {}

  StatusOr<std::vector<Cone>> Choose(const ConeProblem& /*problem*/) const override {
    return std::vector<Cone>();
  }
};

class GivenCones final : public ConeHeuristic {
 public:
  explicit GivenCones(GivenOptions options) : options_(std::move(options)) {}

  StatusOr<std::vector<Cone>> Choose(const ConeProblem& problem) const override {
    const ConeSource& source = problem.source();
    const auto targets = ReadGiven(options_, source.surface->triangulation, source.file);
    if (!targets.ok()) return targets.status();
    return ConesOf(source.surface->triangulation, *targets);
  }

 private:
  GivenOptions options_;
};

using Made = StatusOr<std::shared_ptr<const ConeHeuristic>>;

Made MakeMoving(const OptionMap& map) {
  return MovingCones::Make(map, [](const std::string& name, const OptionMap& options) {
    return MakeConeHeuristic(name, options);
  });
}

Made MakeSeamless(const OptionMap& map) {
  return SeamlessCones::Make(map, [](const std::string& name, const OptionMap& options) {
    return MakeConeHeuristic(name, options);
  });
}

}  // namespace

const Registry<ConeHeuristicFactory>& ConeHeuristics() {
  static const Registry<ConeHeuristicFactory> kTable(
      "cone heuristic",
      {
          {"none", HeuristicFactory<NoCones>(OptionTable<NoOptions>("none", {}))},
          {"given", HeuristicFactory<GivenCones>(GivenOptionTable())},
          {"curvature_peaks", HeuristicFactory<CurvaturePeaks>(CurvaturePeaksOptionTable())},
          {"greedy", HeuristicFactory<GreedyCones>(GreedyOptionTable())},
          {"l1", HeuristicFactory<L1Cones>(L1OptionTable())},
          {"reweighted", HeuristicFactory<ReweightedCones>(ReweightedOptionTable())},
          {"moving", MakeMoving},
          {"seamless", MakeSeamless},
      });
  return kTable;
}

Made MakeConeHeuristic(const std::string& name, const OptionMap& options,
                       const Registry<ConeHeuristicFactory>& heuristics) {
  const auto factory = heuristics.Find(name);
  if (!factory.ok()) return factory.status();
  return (*factory)(options);
}

Made ParseConeHeuristic(const std::string& text, int budget) {
  StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  if (!named.ok()) return named.status();
  if (budget >= 0) named->options["cones"] = std::to_string(budget);
  return MakeConeHeuristic(named->name, named->options);
}

Status CheckConeHeuristic(const std::string& text) { return ParseConeHeuristic(text).status(); }

}  // namespace cirque
