#include "cirque/intrinsic/intrinsic_surface.h"

#include "cirque/intrinsic/corner_angles.h"

namespace cirque {

IntrinsicSurface MeasureSurface(const Triangulation& t, const EdgeLengths& lengths) {
  return {t, lengths, MeasureCornerAngles(t, lengths), BoundaryVertices(t), CornersPerVertex(t)};
}

}  // namespace cirque
