// What names the code of a run: the sources that make it, and nothing else.
#include "experiments/run_experiment/results/run_code.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/version.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/energy/registry.h"

#include "experiments/run_experiment/config/file_content.h"
#include "tests/common/paths.h"

namespace cirque {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::Not;
using ::testing::StartsWith;

MethodSpec WithObjective(const std::string& objective, bool strict = true) {
  MethodSpec method;
  method.options.angle_objective = objective;
  method.options.strict = strict;
  return method;
}

std::vector<std::string> Paths() {
  std::vector<std::string> paths;
  for (const SourceFile& source : RunSources()) paths.emplace_back(source.path);
  return paths;
}

/// The sources, that of the path with another content.
std::vector<SourceFile> WithAnother(const std::string& path) {
  std::vector<SourceFile> changed(RunSources().begin(), RunSources().end());
  const auto found = std::find_if(changed.begin(), changed.end(),
                                  [&](const SourceFile& source) { return source.path == path; });
  EXPECT_NE(found, changed.end()) << path;
  if (found != changed.end()) found->hash = "0123456789abcdef";
  return changed;
}

/// The objectives whose strict runs get another name when the source's content is another.
std::set<std::string> ChangedBy(const std::string& path, bool strict = true) {
  const std::vector<SourceFile> changed = WithAnother(path);
  std::set<std::string> names;
  for (const std::string& objective : AngleObjectives().Names()) {
    const MethodSpec method = WithObjective(objective, strict);
    if (RunCode(method) != RunCode(method, changed)) names.insert(objective);
  }
  return names;
}

TEST(RunCode, IsOfTheSourcesThatMakeRuns) {
  const std::vector<std::string> paths = Paths();
  EXPECT_GT(paths.size(), 300u);
  for (const char* path :
       {"framework/cirque/angles/angle_fit.cc", "framework/cirque/core/parallel.h",
        "experiments/run_experiment/run/map_run.cc"}) {
    EXPECT_THAT(paths, Contains(path));
  }
  for (const char* beginning :
       {"framework/cirque/audit/", "framework/docs/", "tests/", "experiments/experiment_report/",
        "framework/cirque/core/version.cc", "README.md"}) {
    EXPECT_THAT(paths, Each(Not(StartsWith(beginning))));
  }
}

TEST(RunCode, NamesSourcesByTheirContent) {
  std::set<std::string_view> hashes;
  for (const SourceFile& source : RunSources()) {
    EXPECT_TRUE(ReadWholeFile(ProjectPath(std::string(source.path))).ok()) << source.path;
    EXPECT_EQ(source.hash.size(), 16u) << source.path;
    hashes.insert(source.hash);
  }
  EXPECT_EQ(hashes.size(), RunSources().size());
}

TEST(RunCode, OfAnObjectiveChangesWithItsOwnSource) {
  const std::string energy = "framework/cirque/energy/";
  const std::set<std::string> all = ChangedBy(energy + "angle_objective.h");
  EXPECT_EQ(all.size(), AngleObjectives().Names().size());
  EXPECT_EQ(ChangedBy(energy + "entropy_objective.cc"), std::set<std::string>{"entropy"});
  EXPECT_EQ(ChangedBy(energy + "barrier_objective.cc"), std::set<std::string>{"barrier"});
  EXPECT_EQ(ChangedBy(energy + "quadratic_objective.cc"),
            (std::set<std::string>{"least_squares", "quadratic", "weighted_quadratic"}));
}

/// A run that is not strict may end on the quadratic objective, whichever it began with.
TEST(RunCode, CountsWhatTheLadderMayFallBackOn) {
  const std::string energy = "framework/cirque/energy/";
  EXPECT_EQ(ChangedBy(energy + "quadratic_objective.cc", false),
            ChangedBy(energy + "angle_objective.h", false));
  EXPECT_EQ(ChangedBy(energy + "entropy_objective.cc", false), std::set<std::string>{"entropy"});
}

TEST(RunCode, OfMapsEnergiesAndPeersIsOfWhatMakesThem) {
  MethodSpec map, energy, peer;
  energy.trial.energy = "lorentz";
  peer.peer = {"/bin/true", "{in}", "{out}"};
  const struct {
    const char* path;
    bool map, energy, peer;
  } cases[] = {
      {"framework/cirque/verify/map_check.cc", false, false, true},
      {"experiments/run_experiment/run/peer_run.cc", false, false, true},
      {"experiments/run_experiment/run/energy_run.cc", false, true, false},
      {"framework/cirque/solver/newton_loop.cc", true, true, false},
      {"framework/cirque/energy/barrier_objective.cc", false, true, false},
      {"framework/cirque/io/obj.cc", true, true, true},
  };
  for (const auto& [path, changes_map, changes_energy, changes_peer] : cases) {
    const std::vector<SourceFile> changed = WithAnother(path);
    EXPECT_EQ(RunCode(map) != RunCode(map, changed), changes_map) << path;
    EXPECT_EQ(RunCode(energy) != RunCode(energy, changed), changes_energy) << path;
    EXPECT_EQ(RunCode(peer) != RunCode(peer, changed), changes_peer) << path;
  }
}

}  // namespace
}  // namespace cirque
