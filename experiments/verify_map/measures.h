#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/metrics/measure_map.h"

#include "experiments/verify_map/uv_complex.h"

namespace cirque::verify_map {

/// Every registered measure of the map. The metrics know the edge lengths, from the positions, and
/// the UVs, not how the map was made; the verdict does not depend on them.
MapMeasures MeasureComplex(const UvComplex& complex, const std::vector<Eigen::Vector3d>& position);

/// The triangle of the largest quasi-conformal distortion; kNone where none can be measured.
Index WorstTriangle(const MapMeasures& measures);

}  // namespace cirque::verify_map
