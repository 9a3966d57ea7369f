#pragma once

#include <string>
#include <vector>

#include "experiments/common/map_view/raster.h"
#include "experiments/common/map_view/uv_map.h"

namespace cirque {

/// The side of a panel in units of the picture.
inline constexpr double kPanel = 450;

/// The colour of seams, as the viewer's.
inline constexpr float kSeamColour[3] = {0.88f, 0.12f, 0.35f};

/// And those of cones of less and of more than a full angle.
inline constexpr float kLessColour[3] = {0.93f, 0.45f, 0.05f}, kMoreColour[3] = {0.5f, 0.2f, 0.75f};

/// The surface with squares that are those of its image, seams on it, as a square picture of `scale` pixels a
/// unit; of a map on a lattice with the lattice's pattern, and cones on it.
RgbaImage SurfacePanel(const UvMap& map, double scale);

/// The image's faces in these colours: the plane's fitted into a panel, or both sides of the sphere.
/// Flipped faces in the plane are red.
RgbaImage ImagePanel(const UvMap& map, const std::vector<Rgb>& face_colour, double scale);

/// The way from the plane into a panel.
class PanelFit {
 public:
  explicit PanelFit(const UvMap& map);
  Eigen::Vector2d operator()(const Eigen::Vector2d& uv) const;

 private:
  Eigen::Vector2d middle_;
  double scale_ = 1;
};

}  // namespace cirque
