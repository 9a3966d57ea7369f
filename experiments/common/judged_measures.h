#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/metrics/measure_map.h"
#include "cirque/verify/map_check.h"

namespace cirque::verify {

/// Every registered distortion measure of a map that was judged. They know the edge lengths, from
/// the positions, and the UVs, not how the map was made; the verdict does not depend on them. In a
/// map that is proven injective no overlap is searched for: triangle by triangle that takes time
/// quadratic in the valence of a vertex.
MapMeasures MeasureComplex(const UvComplex& complex, const std::vector<Eigen::Vector3d>& position,
                           bool injective = false);

/// The triangle of the largest quasi-conformal distortion; kNone where none can be measured.
Index WorstTriangle(const MapMeasures& measures);

/// The figures in the form that a report shows.
QualityFigures ToQualityFigures(const MapMeasures& measures);

}  // namespace cirque::verify
