#pragma once

#include <string>

#include "experiments/common/map_view/uv_map.h"

namespace cirque {

/// What a picture shows without being told: how areas change, since angles hardly do.
inline constexpr char kPictureMeasure[] = "log_area_ratio";

/// The map as one picture: the surface with squares that the image's are, beside the image in the
/// colours of a distortion measure, seams, cones, boundary, a legend. Faces are drawn as pixels, so
/// that the size does not grow with the mesh. An image on the sphere is seen from both sides.
/// @pre `measure` has values of faces.
///
/// As SVG: lines and words stay sharp, and the page is light or dark as its reader has it.
std::string PictureSvg(const UvMap& map, const std::string& measure = kPictureMeasure);

/// As PNG, on white.
std::string PicturePng(const UvMap& map, const std::string& measure = kPictureMeasure);

}  // namespace cirque
