#pragma once

#include <string>
#include <vector>

#include "cirque/io/polygon_soup.h"
#include "cirque/verify/angle_check.h"
#include "cirque/verify/judged_mesh.h"
#include "cirque/verify/overlap_check.h"
#include "cirque/verify/uv_complex.h"

namespace cirque::verify {

/// The errors that the measures of a report amount to, in the order of the checks. `noun`: what the
/// faces are (FaceNoun).
std::vector<std::string> OrientationErrors(const Orientations& found, const std::string& noun);
std::vector<std::string> AngleErrors(const AngleMeasures& found, double tolerance);
std::vector<std::string> OverlapErrors(const UvComplex& complex, const OverlapResult& found);

}  // namespace cirque::verify
