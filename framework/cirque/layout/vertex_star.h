#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/layout/map_objective.h"

namespace cirque {

/// The faces around a flat interior vertex, developed into the plane with the vertex at 0.
class VertexStar {
 public:
  /// `surface_angles`, `surface_lengths`: of the faces as they are to be.
  VertexStar(const Triangulation& triangulation, const CornerAngles& surface_angles,
             const EdgeLengths& surface_lengths, const InputChart& flat, Index corner);

  /// False where the vertex is its own neighbour: it cannot move alone.
  bool IsSimple() const { return simple_; }

  /// A place for the vertex from which all faces are counter-clockwise, the least distorted near
  /// where relaxation finds the first; nothing where it finds none.
  std::optional<std::complex<double>> BestPlace(const MapObjective& objective) const;

  /// The largest |mu| of the faces with the vertex there.
  double WorstDistortion(std::complex<double> place) const;

  /// Moves the vertex there: the star's angles and the lengths of its spokes.
  void MoveTo(std::complex<double> place, InputChart* flat) const;

 private:
  using Complex = std::complex<double>;
  struct Face {
    Index corner;                   ///< at the vertex
    Complex from, to;               ///< the ends of the side across from it, counter-clockwise
    double area;                    ///< on the surface
    Complex hat, hat_from, hat_to;  ///< gradients of the hat functions, up to one factor
  };

  Complex Beltrami(const Face& face, Complex place, Complex* f_z) const;
  double Value(const MapObjective& objective, Complex place) const;
  std::optional<Complex> PlaceInKernel() const;
  bool SeesAll(Complex place) const;
  double Radius() const;

  const Triangulation& t_;
  std::vector<Face> faces_;
  bool simple_ = true;
};

}  // namespace cirque
