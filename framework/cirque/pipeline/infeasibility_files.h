#pragma once

#include <string>

#include "cirque/core/infeasibility.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// The faces and vertices that carry the proof as CSV: a header `kind,id,multiplier`, then a line
/// for every face and every constrained vertex whose multiplier exceeds a thousandth of the largest
/// of its kind, in increasing ids (0-based, as the proof has them; a polygon has a
/// line for every triangle of it). Only the ratios of multipliers mean anything.
std::string InfeasibilityCsv(const InfeasibilityCertificate& proof);

/// The surface as text PLY with a colour a face (grey: no multiplier; red: positive, blue:
/// negative, the stronger the larger), the mask by which to look at the proof. A face takes the
/// strongest multiplier among its own and its three vertices', each relative to the largest of its
/// kind.
/// @pre the proof's vertices are numbered as in the input file, its faces as in the surface.
std::string InfeasibilityPly(const Surface& surface, const InfeasibilityCertificate& proof);

}  // namespace cirque
