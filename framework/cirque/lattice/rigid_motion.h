#pragma once

#include <complex>

#include <Eigen/Core>

namespace cirque {

/// A turn and a translation of the plane, z -> turn z + shift with |turn| = 1. Of frames: it takes
/// the coordinates of a point in one frame to those in another.
struct RigidMotion {
  std::complex<double> turn = 1, shift = 0;

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const {
    const std::complex<double> z = turn * std::complex<double>(p.x(), p.y()) + shift;
    return {z.real(), z.imag()};
  }

  RigidMotion Inverse() const { return {std::conj(turn), -std::conj(turn) * shift}; }

  /// First `other`, then this.
  RigidMotion operator*(const RigidMotion& other) const {
    const std::complex<double> product = turn * other.turn;
    return {product / std::abs(product), turn * other.shift + shift};
  }

  /// The one that takes a to a2 and the direction of b - a to that of b2 - a2. @pre a != b, a2 != b2.
  static RigidMotion Aligning(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                              const Eigen::Vector2d& a2, const Eigen::Vector2d& b2) {
    const auto of = [](const Eigen::Vector2d& p) { return std::complex<double>(p.x(), p.y()); };
    const std::complex<double> ratio = of(b2 - a2) * std::conj(of(b - a));
    const std::complex<double> turn = ratio / std::abs(ratio);
    return {turn, of(a2) - turn * of(a)};
  }
};

}  // namespace cirque
