#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_heuristic.h"

namespace cirque {

struct SeamlessOptions {
  int cones = -1;                                 ///< that the start chooses; -1: SeamlessBudget
  std::string start = "moving";                   ///< the heuristic that chooses the cones first
  ConeAngleRule angles = ConeAngleRule::kHalves;  ///< kThirds or kFree
};

const OptionTable<SeamlessOptions>& SeamlessOptionTable();

/// How many cones make a closed surface seamless without much ado: 12 a handle beyond the first, at
/// least 8; 12 on a sphere with angles in multiples of pi/3.
int SeamlessBudget(const ConeProblem& problem, ConeAngleRule angles);

/// The cones of another heuristic with angles in multiples of pi/2 or pi/3, moved until the linear
/// model predicts rotations along all handles that are such multiples, too (SeamlessSearch). A
/// surface without handles has none: its cones descend only. With angles free the other heuristic's
/// cones as they are, as many: what to measure the price of the rotations against.
class SeamlessCones final : public ConeHeuristic {
 public:
  /// Makes the heuristic of a name with options, as MakeConeHeuristic does.
  using StartMaker = std::function<StatusOr<std::shared_ptr<const ConeHeuristic>>(
      const std::string& name, const OptionMap& options)>;

  /// Error (invalid input): a start that is itself seamless, or no such heuristic; angles in
  /// ranges.
  static StatusOr<std::shared_ptr<const ConeHeuristic>> Make(const OptionMap& options,
                                                             const StartMaker& make_start);

  SeamlessCones(SeamlessOptions options, StartMaker make_start)
      : options_(std::move(options)), make_start_(std::move(make_start)) {}

  StatusOr<std::vector<Cone>> Choose(const ConeProblem& problem) const override;

 private:
  SeamlessOptions options_;
  StartMaker make_start_;
};

}  // namespace cirque
