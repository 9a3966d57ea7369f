#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "experiments/experiment_report/uv_map.h"

namespace cirque::experiment_report {

/// A map as the viewer in assets/ reads it: numbers of elements, boxes, cones, and in "data" the
/// deflated lists in base64: x, y, z of the vertices, u, v of the points, two colours a face (16
/// bits each, from the low to the high end of the box or the colour scale), then the vertex of each
/// point, the point of each corner, seams and boundary (32 bits each). Vertices are renumbered in
/// the order in which the corners meet them.
nlohmann::json MapPayload(const UvMap& map);

/// The colour scales of the two measures that the viewer shows, of the same ranges for every map:
/// name, meaning, least, greatest, and colours "#rrggbb" from one end to the other.
nlohmann::json ColourScales();

}  // namespace cirque::experiment_report
