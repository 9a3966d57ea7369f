#pragma once

#include "cirque/core/status.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flat_surface.h"

namespace cirque {

/// Flattens a surface by discrete conformal equivalence (SolveLogScales): a flat metric for all
/// angle sums above 0 with Gauss-Bonnet, whatever the input's triangulation. The flat metric's
/// Delaunay triangulation has coherent angles, those of `result`, and is a circle pattern with their
/// radii. A surface with a boundary is solved as it is, and where that leads to none on its double.
/// The input's triangles are read and untangled as by Flatten; of a double the surface's half. Where
/// some stay flipped, the metric equivalent on the input's own triangulation is taken, if there is
/// one.
///
/// `intrinsic` of a double's result is the input without flips. Errors: as SolveLogScales;
/// kUnrepresentable for lengths that doubles do not hold; kNotConverged where triangles of the input
/// come out flipped and no move of a vertex untangles them: the metric exists, the map that is linear
/// on the input's triangles does not. With ParameterizeOptions::exact that is no error, since the
/// exact map does.
Status FlattenByEquivalence(const FlattenJob& job, Certificate* certificate, FlatSurface* result);

/// Whether there is a conformally equivalent flat metric for these targets, as far as angle sums
/// tell: all can be above 0, and with Gauss-Bonnet.
bool HasEquivalentMetric(const IntrinsicSurface& surface, const ConeTargets& targets);

}  // namespace cirque
