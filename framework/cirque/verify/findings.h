#pragma once

#include <string>
#include <vector>

#include "cirque/verify/angle_check.h"
#include "cirque/verify/overlap_check.h"
#include "cirque/verify/uv_plane.h"

namespace cirque::verify {

/// "1 triangle", "3 triangles", "2 vertices".
std::string Count(std::size_t number, const std::string& singular);

/// The errors that the measures of a report amount to, in the order of the checks.
std::vector<std::string> OrientationErrors(const Orientations& found, Index num_triangles);
std::vector<std::string> AngleErrors(const AngleMeasures& found, double tolerance);
std::vector<std::string> OverlapErrors(const UvComplex& complex, const OverlapResult& found);

/// "edge (3, 4) of triangle 7".
std::string NameEdge(const UvComplex& complex, Index halfedge);

}  // namespace cirque::verify
