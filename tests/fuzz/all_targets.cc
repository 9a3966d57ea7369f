#include <iterator>

#include "tests/fuzz/fuzz_target.h"

namespace cirque::testing {

std::vector<FuzzTarget> FuzzTargets() {
  std::vector<FuzzTarget> all;
  for (const auto& targets :
       {MeshTargets, SideFileTargets, VerifierTargets, OptionTargets, ExperimentTargets}) {
    std::vector<FuzzTarget> some = targets();
    all.insert(all.end(), std::make_move_iterator(some.begin()),
               std::make_move_iterator(some.end()));
  }
  return all;
}

}  // namespace cirque::testing
