#pragma once

#include "cirque/solver/newton_on_ranks.h"

namespace cirque {

/// A rank's part of a circle pattern, which can also find the start of its log radii.
class PatternPart final : public NewtonPart {
 public:
  explicit PatternPart(Ranks* ranks);

  /// The task of MaximizePatternVolume, down to a gradient of call.tolerance: call.result.
  static constexpr int kMaximizeVolume = NewtonPart::kNumTasks;

  void Do(int task) override;

 private:
  class Domain;
};

}  // namespace cirque
