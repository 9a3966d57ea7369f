#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/types.h"

namespace cirque::verify {

/// Where an angle sum should lie, in units of pi.
struct AngleInterval {
  double lower_over_pi = 0, upper_over_pi = 0;
};

/// The angle sums that are asked of the vertices of IN.
struct AngleTargets {
  std::vector<std::optional<AngleInterval>> at;  ///< per vertex; may be empty: none is named
  /// What holds at vertices not named: 2 pi inside and anything on the boundary, or anything.
  bool flat_elsewhere = false;

  bool empty() const { return at.empty() && !flat_elsewhere; }
  std::optional<AngleInterval> At(Index v, bool inside) const {
    if (v < static_cast<Index>(at.size()) && at[v]) return at[v];
    if (flat_elsewhere && inside) return AngleInterval{2, 2};
    return std::nullopt;
  }
};

/// The targets where nobody names any: 2 pi inside, anything on the boundary.
AngleTargets DefaultTargets();

/// Reads a file of targets; '#' begins a comment. Either angle sums [rad], one number a line for
/// each of the vertices, or "free" where any will do; or cones, with 2 pi at all other inner
/// vertices, as circle_patterns' -iv takes them:
///
///   vertex min max    the angle sum lies in [min pi, max pi]; vertices count from 1
///   vertex angle      it is angle pi
///
/// The number of words on the first line tells which. Errors name file:line.
StatusOr<AngleTargets> ReadTargets(const std::string& path, Index num_vertices);

}  // namespace cirque::verify
