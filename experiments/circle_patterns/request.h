#pragma once

#include <memory>
#include <optional>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/cuts/edge_files.h"
#include "cirque/domains/domain.h"
#include "cirque/intrinsic/loop_rotations.h"
#include "cirque/io/cone_file.h"
#include "cirque/pipeline/summaries.h"

#include "experiments/circle_patterns/job.h"

namespace cirque {

/// What the job asks of a map of the surface. Vertices that the job names are those of a mesh file
/// with `num_file_vertices` vertices, from 1.
StatusOr<MapRequest> RequestOf(const CirclePatternsJob& job, Index num_file_vertices,
                               const Surface& surface);

/// The angle sums that the job's files prescribe; nothing when it names none. `rounding`: what the
/// cones of a file needed to add up, if they did not.
StatusOr<std::optional<ConeTargets>> PrescribedTargets(
    const CirclePatternsJob& job, const Triangulation& triangulation, const FileVertices& vertices,
    std::optional<ConeRoundingSummary>* rounding);

/// The cut of the job's file or paths (shortest in `lengths`, along sides of faces); nothing when it
/// names neither.
StatusOr<std::optional<Cut>> PrescribedCut(const CirclePatternsJob& job,
                                           const Triangulation& triangulation,
                                           const EdgeLengths& lengths, const FileNumbers& numbers);

/// Those of the job's file, along loops of its surface; none where it names none.
StatusOr<std::shared_ptr<const PrescribedRotations>> RotationsAlongLoops(
    const CirclePatternsJob& job, const Triangulation& triangulation, const FileNumbers& numbers);

}  // namespace cirque
