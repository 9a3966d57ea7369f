#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/energy/energy_source.h"

namespace cirque {

/// A CirclePatternEnergy for ranks, of which the first never has the whole.
class CirclePatternSource final : public EnergySource {
 public:
  /// Both must outlive the source.
  CirclePatternSource(const Triangulation& triangulation, const CoherentAngles& angles)
      : t_(triangulation), angles_(angles) {}

  const char* Work() const override { return kCirclePatternWork; }
  const Triangulation& triangulation() const override { return t_; }
  int NumParameters() const override { return t_.num_faces(); }
  std::vector<int> GaugeParameters() const override { return {0}; }
  std::vector<int> VertexParameters() const override { return {}; }
  EnergyData DataOf(const MeshPart& part) const override {
    EnergyData data;
    data.angles = AtHalfedges(part, angles_.value);
    return data;
  }

 private:
  const Triangulation& t_;
  const CoherentAngles& angles_;
};

}  // namespace cirque
