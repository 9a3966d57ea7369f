#include "experiments/run_experiment/results/run_code.h"

#include <algorithm>
#include <vector>

#include "experiments/run_experiment/config/file_content.h"

namespace cirque {
namespace {

constexpr SourceFile kRunSources[] = {
#include "run_sources.inc"
};

/// Sources whose path begins so, of the angle objectives of these names.
struct ObjectiveSources {
  std::string_view beginning;
  std::vector<std::string_view> objectives;
  bool is_fallback;  ///< whether the ladder takes one of them where another leads to no map
};

const std::vector<ObjectiveSources>& OwnSources() {
  static const std::vector<ObjectiveSources> kTable = {
      {"framework/cirque/energy/quadratic_objective.",
       {"quadratic", "weighted_quadratic", "least_squares"},
       true},
      {"framework/cirque/energy/entropy_objective.", {"entropy"}, false},
      {"framework/cirque/energy/barrier_objective.", {"barrier"}, false},
  };
  return kTable;
}

bool BeginsWithOneOf(std::string_view path, std::span<const std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return path.starts_with(beginning); });
}

/// What only minimises energies, and what only judges other programs' maps.
constexpr std::string_view kOfEnergies[] = {"experiments/common/solver_problem.",
                                            "experiments/run_experiment/config/energy_figures.",
                                            "experiments/run_experiment/run/energy_run."};
constexpr std::string_view kOfPeers[] = {"framework/cirque/verify/",
                                         "experiments/common/judged_measures.",
                                         "experiments/run_experiment/run/peer_run."};
/// What else another program's run is made by: meshes are read and maps are measured.
constexpr std::string_view kAlsoOfPeers[] = {"framework/cirque/core/",
                                             "framework/cirque/io/",
                                             "framework/cirque/math/",
                                             "framework/cirque/mesh/",
                                             "framework/cirque/generators/",
                                             "framework/cirque/metrics/",
                                             "experiments/"};

bool IsUsedBy(const MethodSpec& method, std::string_view path) {
  const bool is_of_energies = BeginsWithOneOf(path, kOfEnergies);
  const bool is_of_peers = BeginsWithOneOf(path, kOfPeers);
  if (!method.peer.empty()) {
    return is_of_peers || (!is_of_energies && BeginsWithOneOf(path, kAlsoOfPeers));
  }
  if (is_of_peers) return false;
  if (method.trial.IsAskedFor()) return true;
  if (is_of_energies) return false;
  const std::string& objective = method.options.angle_objective;
  for (const ObjectiveSources& own : OwnSources()) {
    if (!path.starts_with(own.beginning)) continue;
    return (own.is_fallback && !method.options.strict) ||
           std::find(own.objectives.begin(), own.objectives.end(), objective) !=
               own.objectives.end();
  }
  return true;
}

}  // namespace

std::span<const SourceFile> RunSources() { return kRunSources; }

std::string RunCode(const MethodSpec& method, std::span<const SourceFile> sources) {
#ifdef NDEBUG
  std::string all = "release";
#else
  std::string all = "debug";
#endif
  all += std::string(" ") + __VERSION__;
  for (const SourceFile& source : sources) {
    if (!IsUsedBy(method, source.path)) continue;
    all.append("\n").append(source.path).append(" ").append(source.hash);
  }
  return HashOf(all);
}

}  // namespace cirque
