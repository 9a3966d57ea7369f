#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/metrics/measure_map.h"

namespace cirque {

/// A file for the measures of a map; its ending says which.
struct MeasureFile {
  std::string path;
  std::string colour_by;  ///< of a PLY: the distortion measure whose face values are shown
};

/// Reads "FILE,FILE,...", each FILE.csv (face values), FILE.json (figures), FILE.ply (colours by
/// quasi_conformal) or FILE.ply:MEASURE. Errors: another ending, a measure without face values.
StatusOr<std::vector<MeasureFile>> ParseMeasureFiles(const std::string& list);

/// A line of names,
///   face,MEASURE,MEASURE,...
/// then one row a face, numbered from 0 in the surface's order; nothing where a face is degenerate.
std::string MeasuresCsv(const MapMeasures& measures);

/// The figures by name, null where there is no measurable face, and what they mean:
///   {"measures": {FIGURE: number, ...}, "meanings": {FIGURE: "formula, unit", ...}}
std::string MeasuresJson(const MapMeasures& measures);

/// The triangles in the colours of one distortion measure; the range of values that the colours
/// show, the same for every map, is in the header.
std::string MeasuresPly(const std::vector<Eigen::Vector3d>& position,
                        const std::vector<Index>& corner, const MapMeasures& measures,
                        const std::string& colour_by);

/// Writes all of them; the mesh is that of a PLY, its triangles in the order of the faces measured.
Status WriteMeasureFiles(const std::vector<MeasureFile>& files,
                         const std::vector<Eigen::Vector3d>& position,
                         const std::vector<Index>& corner, const MapMeasures& measures);

/// The colour of a value between `least` and `greatest`; beyond them that of the end, grey for NaN.
/// Ranges on one side of zero: from dark blue through green to light yellow, lightness growing in
/// equal steps. Ranges from negative to positive: from blue through light grey in the middle to
/// red, lightness falling in equal steps to both sides. Both are straight or bent paths in the
/// perceptual space OKLab (B. Ottosson, 2020).
Colour ColourOnScale(double value, double least, double greatest);

}  // namespace cirque
