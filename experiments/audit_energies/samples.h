#pragma once

#include <random>
#include <string>
#include <vector>

#include "experiments/audit_energies/audit.h"

namespace cirque::audit_energies {

/// Repeatable random numbers.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double Uniform(double low, double high);
  Eigen::VectorXd Vector(int n, double size);  ///< entries in [-size, size]
  Eigen::Vector3d UnitVector();

 private:
  std::mt19937 engine_;
};

/// A small bumpy disk with its measured angles, targets 2 pi inside and free on the boundary, and
/// no points.
EnergyInput DiskInput(unsigned seed);

/// A small sphere of which every vertex is a cone.
EnergyInput SphereInput(unsigned seed);

/// Angles around pi/3 in every triangle; theta about pi/3 everywhere.
Eigen::VectorXd RoundAngles(const Triangulation& triangulation, unsigned seed);

/// Equilateral triangles, but in a set of pairs of triangles both angles opposite the common edge
/// are `opposite` and the others equal: pi/2 - tiny makes theta tiny there, tiny makes needles that
/// meet under tiny theta. Above pi/2 the edge is not Delaunay.
Eigen::VectorXd PairedAngles(const Triangulation& triangulation, double opposite);

/// Unit vectors within about `scale` of one direction, random weights.
EnergyInput PointsInput(int n, double scale, unsigned seed);

/// The framework's energies in 50 digits, from their definitions.
ReferenceValue CirclePatternReference(const EnergyInput& input, const Reals& log_radii);
ReferenceValue CoherentAngleBarrierReference(const EnergyInput& input, const Reals& angles);
ReferenceValue LorentzReference(const EnergyInput& input, const Reals& x);

/// The conformal-equivalence energies from lengths, Ptolemy's theorem and the law of cosines; on the
/// triangulation that is Delaunay, or on that of the input.
Reference EquivalenceReference(bool delaunay);

/// Of the dual of the angle fit with the objective of that name: the conjugate of an edge is the
/// largest of its values at every point of Q_e that can be the maximiser, found side by side.
Reference DualReference(const std::string& objective);

}  // namespace cirque::audit_energies
