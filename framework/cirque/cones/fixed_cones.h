#pragma once

#include <string>

#include "cirque/cones/cone_heuristic.h"

namespace cirque {

/// No cones at all: enough for a torus and for every surface with a boundary. On other closed
/// surfaces Gauss-Bonnet then refuses the targets.
class NoCones final : public ConeHeuristic {
 public:
  StatusOr<std::vector<Cone>> Place(const ConeProblem& problem) const override;
};

struct GivenOptions {
  std::string file;  ///< `vertex min max` a line (mesh/cone_file.h)
};

const OptionTable<GivenOptions>& GivenOptionTable();

/// The cones of a file, with their ranges. Errors (invalid input) as of ReadConeFile.
class GivenCones final : public ConeHeuristic {
 public:
  explicit GivenCones(GivenOptions options) : options_(std::move(options)) {}
  StatusOr<std::vector<Cone>> Place(const ConeProblem& problem) const override;

 private:
  GivenOptions options_;
};

}  // namespace cirque
