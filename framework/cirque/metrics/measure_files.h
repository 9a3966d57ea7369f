#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/metrics/measure_map.h"

namespace cirque {

/// A file for measures; its ending says which.
struct MeasureFile {
  std::string path;
  std::string colour_by;  ///< of a PLY: the metric whose face values are shown
};

/// Reads "FILE,FILE,...", each FILE.csv (face values), FILE.json (figures), FILE.ply (colours by
/// quasi_conformal) or FILE.ply:METRIC. Errors: another ending, a metric without face values.
StatusOr<std::vector<MeasureFile>> ParseMeasureFiles(const std::string& list);

/// One row a face, numbered from 0 in the surface's order; nothing where a face is degenerate.
std::string MeasuresCsv(const MapMeasures& measures);

/// The figures by name, null where there is no measurable face, and what they mean.
std::string MeasuresJson(const MapMeasures& measures);

/// The triangles in the colours of one metric; the range of values that the colours show, the same
/// for every map, is in the header.
std::string MeasuresPly(const std::vector<Eigen::Vector3d>& position,
                        const std::vector<Index>& corner, const MapMeasures& measures,
                        const std::string& colour_by);

/// Writes all of them; the mesh is that of a PLY, its triangles in the order of the faces measured.
Status WriteMeasureFiles(const std::vector<MeasureFile>& files,
                         const std::vector<Eigen::Vector3d>& position,
                         const std::vector<Index>& corner, const MapMeasures& measures);

}  // namespace cirque
