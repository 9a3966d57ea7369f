#pragma once

#include <string>
#include <vector>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_problem.h"
#include "cirque/core/option_table.h"

namespace cirque {

/// What becomes of the angles that a heuristic proposes.
struct ConeAngleOptions {
  std::string angles = "free";  ///< a word of ConeAngleWords()
  double width = kPi / 4;       ///< [rad]: half of a range
};

/// free: as they are. pi/2, pi/3: rounded to multiples of that. ranges: an interval about each.
std::vector<std::string> ConeAngleWords();

/// The options from "WORD" or "ranges:width=RADIANS".
StatusOr<ConeAngleOptions> ParseConeAngles(const std::string& text);

/// Applies them to fixed cones at candidates; ranged cones and prescribed boundary vertices stay as
/// they are. Rounded curvatures are the admissible multiples nearest to the proposed ones that add
/// up to 2 pi chi on a closed surface (a cone whose multiple is 0 is none and is dropped); ranges
/// are cut to the admissible angles. Error (invalid input): no admissible multiples add up.
StatusOr<std::vector<Cone>> ApplyConeAngles(const ConeProblem& problem, std::vector<Cone> cones,
                                            const ConeAngleOptions& options);

}  // namespace cirque
