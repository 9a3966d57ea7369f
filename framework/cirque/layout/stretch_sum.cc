#include "cirque/layout/stretch_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cirque {
namespace {

constexpr int kUnitSteps = 60;  ///< of Newton's method, the most
constexpr double kLongestUnitStep = 1;
constexpr double kUnitIsBest = 1e-12;

}  // namespace

/// Of differences, as the hats' gradients sum to zero.
FaceDerivatives DerivativesOn(const BeltramiFace& face, double unit, const Eigen::VectorXcd& z) {
  const std::complex<double> origin = z[face.vertex[0]];
  const std::complex<double> first = z[face.vertex[1]] - origin,
                             second = z[face.vertex[2]] - origin;
  const double scale = unit * face.scale;
  return {scale * (first * std::conj(face.hat[1]) + second * std::conj(face.hat[2])),
          scale * (first * face.hat[1] + second * face.hat[2])};
}

double StretchOf(const std::vector<BeltramiFace>& faces, const StretchEnergy& energy, double unit,
                 const Eigen::VectorXcd& z) {
  double sum = 0;
  for (const BeltramiFace& face : faces) {
    if (!(face.weight > 0)) continue;
    const auto [a, b] = DerivativesOn(face, unit, z);
    const double p = std::norm(a), r = std::norm(b);
    if (!(p > r)) return std::numeric_limits<double>::infinity();
    sum += face.weight * energy.terms(p, r, energy.weight).value;
  }
  return sum;
}

double BestUnit(const std::vector<BeltramiFace>& faces, const StretchEnergy& energy,
                const Eigen::VectorXcd& z) {
  double log_unit = 0;
  for (int step = 0; step < kUnitSteps; ++step) {
    double slope = 0, curvature = 0;
    for (const BeltramiFace& face : faces) {
      if (!(face.weight > 0)) continue;
      const auto [a, b] = DerivativesOn(face, std::exp(log_unit), z);
      const double p = std::norm(a), r = std::norm(b);
      const StretchTerms e = energy.terms(p, r, energy.weight);
      slope += face.weight * 2 * (p * e.p + r * e.r);
      curvature +=
          face.weight * 4 * (p * e.p + r * e.r + p * p * e.pp + 2 * p * r * e.pr + r * r * e.rr);
    }
    // Where it bends down, a step of length 1 the way down.
    const double move = -slope / std::max(curvature, std::abs(slope) / kLongestUnitStep);
    if (!(std::abs(move) > kUnitIsBest)) break;
    log_unit += std::clamp(move, -kLongestUnitStep, kLongestUnitStep);
  }
  return std::exp(log_unit);
}

}  // namespace cirque
