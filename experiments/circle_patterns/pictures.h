#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/pipeline/certificate.h"

#include "experiments/common/map_view/uv_map.h"

namespace cirque {

/// Refuses names that do not say what to write: a view is .html, a picture .svg or .png, or FILE:MEASURE
/// with a distortion measure that faces have.
Status CheckPictures(const std::string& view, const std::string& picture);

/// The file of a picture "FILE:MEASURE".
std::string PictureFile(const std::string& picture);

/// Writes the page with the viewer and the picture of the map as far as they are asked for. `title`
/// names the mesh.
Status WritePictures(const std::string& view, const std::string& picture, const std::string& title,
                     const UvMap& map, const Certificate& certificate, std::ostream& report);

}  // namespace cirque
