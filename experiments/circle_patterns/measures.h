#pragma once

#include <ostream>
#include <vector>

#include "experiments/circle_patterns/run.h"

namespace cirque {

/// The map's measures in the files that the job asks for, colours on the mesh given.
Status WriteMeasures(const CirclePatternsJob& job, const Triangulation& triangulation,
                     const EdgeLengths& lengths, const CornerUv& uv,
                     const std::vector<Eigen::Vector3d>& position, const std::vector<Index>& corner,
                     std::ostream& report);

}  // namespace cirque
