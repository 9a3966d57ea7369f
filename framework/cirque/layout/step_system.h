#pragma once

#include <Eigen/Core>

namespace cirque {

/// The stiffness of a seam's constraint over that of the faces beside it.
inline constexpr double kSeamStiffness = 1e8;

/// An energy of the positions z of a part of a map, and the quadratic models by which a descent
/// (gauss_newton.h) chooses its steps. Gradients are by z, in the vertices that move, as complex
/// numbers: along dz the energy changes by Re(gradient* dz).
class StepSystem {
 public:
  virtual ~StepSystem() = default;

  /// At positions of all of the part's vertices; infinite where there is no energy.
  virtual double Value(const Eigen::VectorXcd& z) const = 0;

  /// Makes and factors the model at z, with the seams' constraints as penalties. Each diagonal entry
  /// is raised by `shift` of itself, for what the energy does not see. False where that is not
  /// positive definite in floating point. @pre Value(z) is finite.
  virtual bool Factorize(const Eigen::VectorXcd& z, double shift) = 0;

  /// The model's matrix times x = right side, in the vertices that move, along their rails. @pre
  /// Factorize returned true.
  virtual Eigen::VectorXcd Solve(const Eigen::VectorXcd& right_side) const = 0;

  virtual const Eigen::VectorXcd& gradient() const = 0;
  virtual const Eigen::VectorXd& penalty() const = 0;  ///< of each seam

  /// How far along `direction` a step may be sought. More than 1: the models are so stiff that going on
  /// beyond their minimum pays.
  virtual double LongestStep(const Eigen::VectorXcd& z,
                             const Eigen::VectorXcd& direction) const = 0;
};

}  // namespace cirque
