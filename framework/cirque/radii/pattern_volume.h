#pragma once

#include <Eigen/Core>

#include "cirque/energy/circle_pattern_energy.h"

namespace cirque {

/// Relative residual of the systems for changes of the multipliers.
inline constexpr double kVolumeTolerance = 1e-2;

/// Where MaximizePatternVolume makes its steps: on the whole surface, or on a rank's part of it.
class VolumeDomain {
 public:
  virtual ~VolumeDomain() = default;

  /// change = A^-1 (right_side - A rho), A damped. False where that fails.
  virtual bool SolveForChange(SparseMatrix* lower, const Eigen::VectorXd& right_side,
                              const Eigen::VectorXd& rho, Eigen::VectorXd* change) = 0;

  /// Of all parts, from this one's.
  virtual double Sum(double mine) = 0;
  virtual double Least(double mine) = 0;
  virtual double LargestEntry(const Eigen::VectorXd& gradient) = 0;

  /// Whether this part adds up the edges on whose left that face is.
  virtual bool Counts(Index face) const = 0;
};

/// MaximizePatternVolume in a domain, `angles` those of its triangulation.
void MaximizeVolume(const Triangulation& triangulation, const Eigen::VectorXd& angles,
                    const CirclePatternEnergy& energy, double gradient_max, VolumeDomain* domain,
                    Eigen::VectorXd* rho);

}  // namespace cirque
