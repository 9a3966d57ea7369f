#include "cirque/cones/given_file.h"

namespace cirque {

const OptionTable<GivenOptions>& GivenOptionTable() {
  static const OptionTable<GivenOptions> kTable(
      "given", {{"file", &GivenOptions::file, "a cone file: 'vertex min max' a line"}});
  return kTable;
}

StatusOr<ConeTargets> ReadGiven(const GivenOptions& options, const Triangulation& triangulation,
                                const FileVertices& vertices) {
  if (options.file.empty()) {
    return Status::InvalidInput("given: name the cone file, as in given:file=PATH");
  }
  return ReadConeFile(options.file, triangulation, vertices);
}

}  // namespace cirque
