#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/option_table.h"
#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// What a map must be, as the flags of verify_map say it.
struct JudgeOptions {
  std::string domain = "plane";  ///< "disk": the boundary lies on the unit circle; "round_holes"
  double position_tolerance = 1e-6;  ///< a vertex may be off by this part of the bounding box
  double angle_tolerance = 1e-6;     ///< [rad]: a seam vertex off 2 pi by more is a cone
  double circle_tolerance = 1e-14;   ///< of the unit circle
  double radius_tolerance = 1e-12;   ///< of points on the sphere
  bool require_injective = false;    ///< an overlap makes the map invalid
};

/// The table of its fields.
const OptionTable<JudgeOptions>& JudgeOptionTable();

/// What the independent judge says of a map (programs of other origin included).
struct MapVerdict {
  bool valid = false;
  std::string verdict;              ///< "valid (injective)", "INVALID: ..."
  std::vector<std::string> errors;  ///< why it is invalid
  std::string json;                 ///< all that was found, as verify_map --json writes it
};

/// Judges the map that `mapped`'s texture coordinates are of the surface `mesh`, exactly where it
/// can: orientation of every triangle, seams, overlaps. Shares no code with what makes maps. A wrong
/// map is a verdict; errors (invalid input) are of a mesh that is no surface.
StatusOr<MapVerdict> JudgeMap(const PolygonSoup& mesh, const PolygonSoup& mapped,
                              const JudgeOptions& options = {});

/// The same of a map to the unit sphere: a point for every vertex of the mesh.
StatusOr<MapVerdict> JudgeSphereMap(const PolygonSoup& mesh,
                                    const std::vector<Eigen::Vector3d>& position,
                                    const JudgeOptions& options = {});

}  // namespace cirque
