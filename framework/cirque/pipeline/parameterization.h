#pragma once

#include <optional>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/layout/exact_map.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flat_surface.h"

namespace cirque {

/// What comes out of every stage.
struct Parameterization {
  ConeTargets targets;  ///< what the angle sums were asked to be in the end
  FlatSurface flat;
  Cut cut;      ///< edges of the surface along which it was opened for the layout
  CornerUv uv;  ///< of the surface's own corners; several at a vertex on the cut
  /// With ParameterizeOptions::exact. Its faces and corners of the input are the surface's own; its
  /// first points are the vertices of the surface, or of the surface opened before it was solved.
  std::optional<ExactMap> exact_map;
  Certificate certificate;  ///< filled as far as the stages came, whatever the outcome
};

}  // namespace cirque
