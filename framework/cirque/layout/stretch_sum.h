#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

#include "cirque/layout/beltrami_system.h"
#include "cirque/layout/stretch_energy.h"

namespace cirque {

/// a = f_z and b = f_zbar of a face, by lengths on the surface of area 1, times `unit`.
struct FaceDerivatives {
  std::complex<double> a, b;
};
FaceDerivatives DerivativesOn(const BeltramiFace& face, double unit, const Eigen::VectorXcd& z);

/// The energy's weighted sum over faces, their derivatives times `unit`; infinite where a face with
/// a weight is flipped.
double StretchOf(const std::vector<BeltramiFace>& faces, const StretchEnergy& energy, double unit,
                 const Eigen::VectorXcd& z);

/// The factor on the image at which that sum is least: Newton's method in its logarithm. @pre the
/// sum is finite at some factor.
double BestUnit(const std::vector<BeltramiFace>& faces, const StretchEnergy& energy,
                const Eigen::VectorXcd& z);

}  // namespace cirque
