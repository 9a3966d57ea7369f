#pragma once

#include <functional>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/cone_file.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flat_surface.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// Whether the options name a shape for the boundary of the surface; of a closed one that free seams
/// open later they do so for what is opened.
bool AsksForBoundary(const IntrinsicSurface& surface, const ParameterizeOptions& options);

/// Whether no angle sum on the boundary is prescribed.
bool HasFreeBoundary(const IntrinsicSurface& surface, const ConeTargets& targets);

/// Flatten, or another way to a flat metric.
using FlattenMethod = std::function<Status(const FlattenJob&, Certificate*, FlatSurface*)>;

/// Flattens with the boundary that the job's options name (cones/boundaries.h), where the job's
/// targets leave it free: predicted on the metric's intrinsic Delaunay connectivity, then the circle
/// pattern's own to the last digits. Where there are no coherent angles with it the angle sums may
/// range over more and more about the prediction, unless the options are strict. `file`: how a cone
/// file numbers the vertices; `flatten`: by what. `targets` receives those that were solved for.
/// Errors: those of `flatten`; kInvalidInput for a surface without a boundary, and for a boundary that
/// its corners cannot turn.
Status FlattenWithBoundary(const FlattenJob& job, const FileVertices& file,
                           const FlattenMethod& flatten, Certificate* certificate,
                           ConeTargets* targets, FlatSurface* flat);

}  // namespace cirque
