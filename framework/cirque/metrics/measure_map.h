#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/metrics/distortion_measure.h"
#include "cirque/metrics/mapped_faces.h"

namespace cirque {

/// All that the registered distortion measures say of a map.
struct MapMeasures {
  struct FaceValues {
    std::string measure;  ///< its name
    std::string meaning;
    double least = 0, greatest = 1;  ///< the values at the two ends of the colours
    Eigen::VectorXd value;           ///< F; NaN at degenerate faces
  };
  struct Figure {
    std::string group, name, meaning;
    double value = 0;
  };

  std::vector<FaceValues> faces;  ///< of the measures that have them, in the registry's order
  std::vector<Figure> figures;    ///< in the registry's order

  /// @pre there is one of that name.
  double ValueOf(const std::string& figure) const;
  const FaceValues& FaceValuesOf(const std::string& measure) const;
};

/// What these measures say of a map to the plane; `angles` as for MeasureFaces. A program with a
/// measure of its own hands on a larger table:
///   MeasureMap(triangulation, lengths, uv, nullptr, DistortionMeasures().With("mine", measure)).
MapMeasures MeasureMap(const Triangulation& triangulation, const EdgeLengths& lengths,
                       const CornerUv& uv, const CornerAngles* angles = nullptr,
                       const Registry<DistortionMeasure>& measures = DistortionMeasures());

/// Only the figures named, by only the measures that they need. Error: a name that no figure has.
StatusOr<std::map<std::string, double>> MeasureFigures(const Triangulation& triangulation,
                                                       const EdgeLengths& lengths,
                                                       const CornerUv& uv,
                                                       const std::vector<std::string>& names);

/// The names of all figures, in the registry's order.
std::vector<std::string> FigureNames();

/// The figures as aligned lines "NAME  VALUE  MEANING" under the headings of their groups.
std::string FormatFigures(const MapMeasures& measures);

}  // namespace cirque
