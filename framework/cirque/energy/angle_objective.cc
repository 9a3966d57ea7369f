#include "cirque/energy/angle_objective.h"

#include <glog/logging.h>

#include "cirque/core/parallel.h"

namespace cirque {

void AngleObjective::Distances(std::span<const double> references, std::span<const double> x,
                               std::span<ScalarJet> jets) const {
  CHECK(references.size() == jets.size() && x.size() == jets.size());
  ParallelFor(static_cast<int>(jets.size()),
              [&](int i) { jets[i] = Distance(references[i], x[i]); });
}

void AngleObjective::Conjugates(std::span<const EdgeSlopes> edges, double epsilon,
                                std::span<EdgeConjugate> conjugates) const {
  CHECK_EQ(edges.size(), conjugates.size());
  ParallelFor(static_cast<int>(edges.size()),
              [&](int e) { conjugates[e] = Conjugate(edges[e], epsilon); });
}

}  // namespace cirque
