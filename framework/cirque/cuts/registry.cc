#include "cirque/cuts/registry.h"

#include "cirque/cuts/preferring_cuts.h"
#include "cirque/cuts/visibility_cuts.h"

namespace cirque {
namespace {

class FlatLengthCuts final : public CutHeuristic {
 public:
  explicit FlatLengthCuts(NoOptions /*options*/) {}

  StatusOr<Eigen::VectorXd> EdgeCosts(const CutProblem& problem) const override {
    return problem.flat.value;
  }
};

class LengthCuts final : public CutHeuristic {
 public:
  explicit LengthCuts(NoOptions /*options*/) {}

  StatusOr<Eigen::VectorXd> EdgeCosts(const CutProblem& problem) const override {
    return problem.surface.lengths.value;
  }
};

constexpr char kFullest[] = "fullest";

/// All the others; alone it is as the first of them.
class FullestCuts final : public CutHeuristic {
 public:
  explicit FullestCuts(NoOptions /*options*/) {}

  StatusOr<Eigen::VectorXd> EdgeCosts(const CutProblem& problem) const override {
    return problem.flat.value;
  }

  std::vector<std::string> Candidates() const override {
    std::vector<std::string> names = CutHeuristics().Names();
    std::erase(names, kFullest);
    return names;
  }
};

/// The table of a heuristic without options.
OptionTable<NoOptions> None(const char* name) { return {name, {}}; }

using Made = StatusOr<std::shared_ptr<const CutHeuristic>>;

}  // namespace

const Registry<CutHeuristicFactory>& CutHeuristics() {
  static const Registry<CutHeuristicFactory> kTable(
      "cut heuristic", {
                           {"flat_length", CutFactory<FlatLengthCuts>(None("flat_length"))},
                           {"length", CutFactory<LengthCuts>(None("length"))},
                           {"distortion", CutFactory<DistortionCuts>(None("distortion"))},
                           {"curvature", CutFactory<CurvatureCuts>(None("curvature"))},
                           {"visibility", CutFactory<VisibilityCuts>(VisibilityOptionTable())},
                           {kFullest, CutFactory<FullestCuts>(None(kFullest))},
                       });
  return kTable;
}

Made MakeCutHeuristic(const std::string& name, const OptionMap& options,
                      const Registry<CutHeuristicFactory>& heuristics) {
  const auto factory = heuristics.Find(name);
  if (!factory.ok()) return factory.status();
  return (*factory)(options);
}

Made ParseCutHeuristic(const std::string& text) {
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  if (!named.ok()) return named.status();
  return MakeCutHeuristic(named->name, named->options);
}

Status CheckCutHeuristic(const std::string& text) { return ParseCutHeuristic(text).status(); }

}  // namespace cirque
