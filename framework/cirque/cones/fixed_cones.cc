#include "cirque/cones/fixed_cones.h"

#include "cirque/io/cone_file.h"

namespace cirque {

StatusOr<std::vector<Cone>> NoCones::Place(const ConeProblem&) const { return std::vector<Cone>(); }

const OptionTable<GivenOptions>& GivenOptionTable() {
  static const OptionTable<GivenOptions> kTable(
      "given", {{"file", &GivenOptions::file, 0, 0, {}, "a cone file: 'vertex min max' a line"}});
  return kTable;
}

StatusOr<std::vector<Cone>> GivenCones::Place(const ConeProblem& problem) const {
  if (options_.file.empty()) {
    return Status::InvalidInput("given: name the cone file, as in given:file=PATH");
  }
  const ConeSource& source = problem.source();
  const StatusOr<ConeTargets> targets =
      ReadConeFile(options_.file, *source.triangulation, source.file);
  if (!targets.ok()) return targets.status();
  return ConesOf(*source.triangulation, *targets);
}

}  // namespace cirque
