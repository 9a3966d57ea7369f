#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cirque/angles/angle_fit_problem.h"
#include "cirque/core/status.h"
#include "cirque/intrinsic/dual_paths.h"
#include "cirque/intrinsic/loop_rotations.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flat_surface.h"
#include "cirque/pipeline/options.h"
#include "cirque/pipeline/parameterization.h"

namespace cirque {

/// What the rotations along loops are to be multiples of [rad]; nothing: they may be any.
std::optional<double> RotationUnit(HolonomyRule holonomy);

/// The loops of a triangulation that all others are made up of but for those around vertices, as
/// weights of corners: a loop's rotation is `offset` plus the weighted sum of angles. First those
/// of HandleLoops, then one around each boundary loop but the first, which
/// Gauss-Bonnet settles.
struct LoopBasis {
  LoopBasis() = default;
  explicit LoopBasis(const Triangulation& triangulation);

  Eigen::VectorXd Rotations(const Eigen::VectorXd& angles) const;  ///< [rad]

  std::vector<SignedCorners> loops;
  std::vector<double> offset;  ///< [rad]
  int handle_loops = 0;
};

/// Whether rotations along the job's loops are to be met.
bool MeetsRotations(const FlattenJob& job);

/// Of prescribed loops of `input`, the surface's triangulation, in the one that the metric was
/// solved on.
LoopBasis LoopsOf(const PrescribedRotations& rotations, const Triangulation& input,
                  const FlatSurface& flat);

/// The rotations of the flat metric; nothing where it has neither handles nor two boundary loops.
std::optional<RotationSummary> MeasureRotations(const FlatSurface& flat);

/// Notes how far the rotations are from the multiples that the options ask for, if they do.
void NoteMiss(const ParameterizeOptions& options, const FlatSurface& flat,
              Certificate* certificate);

/// The largest distance of rotations to multiples of the unit, and whose it is; 0 and -1 for none.
struct RotationMiss {
  double largest = 0;
  int loop = -1;
};
RotationMiss MissOf(const Eigen::VectorXd& rotations, double unit);

/// Notes in the certificate what the metric's rotations along prescribed loops are, and by how much
/// they miss.
void NoteLoops(const Triangulation& input, const PrescribedRotations& rotations,
               Parameterization* result);

/// Changes the angles of a circle pattern so that its rotations are the multiples of the unit
/// nearest to what they are, or those prescribed along the job's loops: Newton's method on
/// r(alpha), with the derivative of the finished metric (RotationGradients), each step the angles
/// nearest to the references, or, once little is missing, to the last ones, under the same
/// equations and inequalities, with the linearised rotations as equations more (FitWithRows), and
/// the radii of those angles. Half a step where a whole one misses by more.
///
/// `problem` is the fit that `flat` came out of. Where the rotations cannot be met to 1e-10 rad, or
/// only by angles that change by more than `kMostAngleChange`, flat stays as it was and the summary
/// says by how much they miss. Along prescribed loops angles may change by any amount: whoever
/// prescribes rotations where the cones lie elsewhere has angles sheared. Fails only when cancelled.
Status CloseRotations(const FlattenJob& job, const AngleFitProblem& problem,
                      Certificate* certificate, FlatSurface* flat);

inline constexpr double kMostAngleChange = 0.5;  ///< [rad]

}  // namespace cirque
