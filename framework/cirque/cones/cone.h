#pragma once

#include <string>
#include <vector>

#include "cirque/cones/cone_problem.h"
#include "cirque/core/metric.h"
#include "cirque/core/option_table.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A vertex whose angle sum Theta_v shall lie in [lower, upper] [rad]; fixed when they are equal.
struct Cone {
  Index vertex = kNone;
  double lower = 0, upper = 0;
};

/// A cone of this curvature 2 pi - Theta_v.
inline Cone ConeOfCurvature(Index vertex, double curvature) {
  return {vertex, 2 * kPi - curvature, 2 * kPi - curvature};
}

/// The targets of a surface with these cones: every other interior vertex flat, every other
/// boundary vertex free. Errors (invalid input): a vertex that does not exist or is named twice, an
/// interval that is empty, has no positive angle or begins at or above pi a corner, and, on a
/// closed surface, angle sums that cannot add up to pi F (Gauss-Bonnet) to within 1e-9 rad.
StatusOr<ConeTargets> ConeTargetsOf(const Triangulation& triangulation,
                                    const std::vector<Cone>& cones);

/// The same of any number of components, whatever their angle sums add up to.
StatusOr<ConeTargets> TargetsAtCones(const Triangulation& triangulation,
                                     const std::vector<Cone>& cones);

/// The way back: the vertices whose targets are not those of FreeBoundaryTargets.
std::vector<Cone> ConesOf(const Triangulation& triangulation, const ConeTargets& targets);

/// free: as they are. pi/2, pi/3: rounded to multiples of that. ranges: an interval about each.
enum class ConeAngleRule { kFree, kHalves, kThirds, kRanges };

template <>
inline constexpr auto kEnumWords<ConeAngleRule> =
    std::to_array<EnumWord<ConeAngleRule>>({{ConeAngleRule::kFree, "free"},
                                            {ConeAngleRule::kHalves, "pi/2"},
                                            {ConeAngleRule::kThirds, "pi/3"},
                                            {ConeAngleRule::kRanges, "ranges"}});

/// What becomes of the angles that a heuristic proposes.
struct ConeAngleOptions {
  ConeAngleRule angles = ConeAngleRule::kFree;
  double width = kPi / 4;  ///< [rad]: half of a range
};

/// The options from "WORD" or "ranges:width=RADIANS".
StatusOr<ConeAngleOptions> ParseConeAngles(const std::string& text);

/// Whether the text is that.
Status CheckConeAngles(const std::string& text);

/// Applies them to fixed cones at candidates; ranged cones and prescribed boundary vertices stay as
/// they are. Rounded curvatures are the admissible multiples nearest to the proposed ones that add
/// up to 2 pi chi on a closed surface (a cone whose multiple is 0 is none and is dropped); ranges
/// are cut to the admissible angles. Error (invalid input): no admissible multiples add up.
StatusOr<std::vector<Cone>> ApplyConeAngles(const ConeProblem& problem, std::vector<Cone> cones,
                                            const ConeAngleOptions& options);

}  // namespace cirque
