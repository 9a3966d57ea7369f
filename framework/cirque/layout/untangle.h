#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/map_objective.h"

namespace cirque {

/// The faces around a flat interior vertex, developed into the plane with the vertex at 0.
class DevelopedStar {
 public:
  /// `surface_angles`, `surface_lengths`: of the faces as they are to be.
  DevelopedStar(const Triangulation& triangulation, const CornerAngles& surface_angles,
                const EdgeLengths& surface_lengths, const InputChart& flat, Index corner);

  /// False where the vertex is its own neighbour: it cannot move alone.
  bool IsSimple() const { return simple_; }

  /// A position for the vertex from which all faces are counter-clockwise, the least distorted near
  /// where relaxation finds the first; nothing where it finds none.
  std::optional<std::complex<double>> BestPosition(const MapObjective& objective) const;

  /// The largest |mu| of the faces with the vertex there.
  double WorstDistortion(std::complex<double> position) const;

  /// Moves the vertex there: the star's angles and the lengths of its spokes.
  void MoveTo(std::complex<double> position, InputChart* flat) const;

 private:
  using Complex = std::complex<double>;
  struct Face {
    Index corner;                   ///< at the vertex
    Complex from, to;               ///< the ends of the side across from it, counter-clockwise
    double area;                    ///< on the surface
    Complex hat, hat_from, hat_to;  ///< gradients of the hat functions, up to one factor
  };

  Complex Beltrami(const Face& face, Complex position, Complex* f_z) const;
  double Value(const MapObjective& objective, Complex position) const;
  std::optional<Complex> PositionInKernel() const;
  bool KernelIsEmpty(double margin, double radius) const;
  bool SeesAll(Complex position) const;
  double Radius() const;

  const Triangulation& t_;
  std::vector<Face> faces_;
  bool simple_ = true;
};

/// Untangles flipped triangles of a flat metric by moving single vertices, each in the plane of its
/// own star: into the star's kernel, the points that see all its faces counter-clockwise, and there
/// to where the faces around it are least distorted (the objective mips of MapObjectives,
/// Gauss-Newton in one complex unknown). No angle sum changes but by whole turns, which flipped
/// triangles can take away, and no face outside the star. Of a flipped triangle that vertex moves
/// which leaves the least distorted star.
///
/// `surface`: what shall be distorted little. `movable`, V: interior vertices whose angles add up to 2 pi. Updates `flat`, whose list of flipped
/// triangles then holds those that no such move untangles. Returns the number of moves.
int UntangleFlippedTriangles(const IntrinsicSurface& surface, const std::vector<bool>& movable,
                             InputChart* flat);

}  // namespace cirque
