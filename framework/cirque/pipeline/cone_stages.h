#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_problem.h"
#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/cone_file.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flatten.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// A surface on which cones are sought, once or again and again.
class ConeSite {
 public:
  /// `file`: how a cone file numbers the vertices; empty: in order. The surface must outlive this.
  explicit ConeSite(const IntrinsicSurface& surface, FileVertices file = {});
  ~ConeSite();

  const IntrinsicSurface& surface() const { return surface_; }

  /// The problem on the metric's intrinsic Delaunay connectivity. Most surfaces ask for it once, so it is
  /// kept only from the second time on.
  std::shared_ptr<const ConeProblem> Problem() const;

 private:
  struct Kept;

  const IntrinsicSurface& surface_;
  FileVertices file_;
  mutable bool asked_ = false;
  mutable std::shared_ptr<const Kept> kept_;
};

/// Interior vertices flat, boundary vertices free. A closed surface: as many cones as those of
/// SimpleConeTargets, or as many more as one chart needs (ConesForOneChart), moved by
/// `moving:measure=angle`; where there are no such, as many as Gauss-Bonnet needs, by `greedy`. A torus: none, or 8 moved cones where without them its area
/// would range over more than e^4, and with them over e to at most .8 of that, as the linear model
/// predicts.
StatusOr<ConeTargets> DefaultTargets(const ConeSite& site);

/// The least of count, 2 count, 4 count, ... cones by `greedy` with which the linear model predicts
/// areas to range over no more than e^28, beyond which doubles leave the smallest triangles of one
/// chart fewer than 8 digits; at most 512 or a sixteenth of the vertices, unless `count` is more.
int ConesForOneChart(const ConeSite& site, int count);

/// The targets that the options' cone heuristic chooses, with the angles the options ask for;
/// DefaultTargets when they name no heuristic. Errors (invalid input): an
/// unknown name or option, cones of a file that Gauss-Bonnet or the corners forbid, a surface that
/// can carry none. A budget that is too small for Gauss-Bonnet, or for angles that are multiples, is
/// exceeded.
StatusOr<ConeTargets> PlaceCones(const ConeSite& site, const ParameterizeOptions& options);

/// The cones that the options' heuristic chooses in a problem, with the angles that the options ask
/// for, and with more cones where those leave no multiples that add up. Errors as of PlaceCones.
StatusOr<std::vector<Cone>> ChooseCones(const ConeProblem& problem,
                                        const ParameterizeOptions& options);

/// PlaceCones for rotations that are multiples (ParameterizeOptions::holonomy): cones with angles
/// of such multiples, on a closed surface moved by SeamlessSearch to where the rotations are near
/// multiples. The linear model that predicts them errs by up to .1 rad: the surface is made flat
/// with the cones, and where the finished rotations miss by more than .02 rad, which the angles
/// then would close at a price, the cones are moved once more for predictions that are right where
/// they were, at most four times; those that miss least are returned. Cones of a file, and those of
/// a surface with a boundary, whose free angles close any rotation, stay where the heuristic puts
/// them. The summary says what was done.
StatusOr<ConeTargets> PlaceSeamlessCones(const ConeSite& site, const ParameterizeOptions& options,
                                         const SolveControl& control, HolonomySummary* summary);

/// What a repair did.
struct ConeRepair {
  ConeTargets targets;
  int moved = 0, widened = 0;  ///< cones
};

/// Changes the inner cones of infeasible targets where the proof points: those at its carrying
/// vertices or next to one; all cones where it points at none. In round 1 each of them moves to the
/// neighbour with most corners, if that has more and is no cone yet; in round k > 1 its angle may
/// range over +- (k - 1) pi/4, and that of every other cone over a quarter of that, which Gauss-
/// Bonnet needs. Angles stay within what the corners can reach.
ConeRepair RepairCones(const IntrinsicSurface& surface, const ConeTargets& targets,
                       const InfeasibilityCertificate& proof, int round);

inline constexpr int kMostConeRepairs = 5;

/// Lowers the realised area distortion (AreaDistortion) of a flat surface by the angles of its
/// inner cones, which stay where they are: at most `options.refine_cones` steps of a quasi-Newton
/// method (BFGS), whose first Hessian is that of the linear model (ConeFit), on the triangulation
/// where the surface was solved, with the gradient of AreaDistortionGradient and a line search on
/// the realised distortion. On a closed surface the sum of the angles stays; angles stay
/// admissible. Ranged cones start at the angles the fit chose. At last everything is solved again
/// as Flatten does; where that is no better, flat and targets stay as they were.
///
/// `targets` and `flat` are those that the job ended in; summaries of the last solve and of the
/// refinement go to the certificate. Fails only when cancelled, or for options that Flatten
/// refuses.
Status RefineCones(const FlattenJob& job, Certificate* certificate, ConeTargets* targets,
                   FlatSurface* flat);

/// D = 1/2 sum_f a_f x_f^2 of a flat surface, x_f the logarithm of flat area over area of face f of
/// the triangulation where it was solved, a_f its area, all areas of total 1: half the square of
/// log_area_ratio_l2 there.
double AreaDistortion(const FlatSurface& flat);

/// dD / dTheta_v for every vertex (V; 0 where the angle sum is not prescribed), by the implicit
/// functions that the solves define: log radii rho(alpha) with grad S(rho, alpha) = 0, angles
/// alpha(Theta) = alpha(A' y) with A alpha = b. Two adjoint solves, with the Hessian of S and with
/// the dual's A P' A':
///   S'' lambda = D_rho,   q = D_alpha - lambda' (grad S)_alpha,   z = (A P' A')^-1 A P' q,
/// and dD / dTheta_v is z in the row of v. Where every vertex is prescribed it is known up to a
/// constant, since Gauss-Bonnet fixes the sum. D is smooth but where an inequality of the fit
/// becomes active.
///
/// `targets` are those of flat's triangulation, single angles; `objective` is that of the fit.
Eigen::VectorXd AreaDistortionGradient(const FlatSurface& flat, const ConeTargets& targets,
                                       const AngleObjective& objective);

/// 1/p sum_f a_f |u_f|^p of a flat surface, u_f = x_f / 2 about its mean by area, x_f and a_f as in
/// AreaDistortion: for p = 2 half the square of log_scale_l2, for large p a smooth log_scale_max, there.
double LogScaleNorm(const FlatSurface& flat, int power);

/// Its derivative by every angle sum, as AreaDistortionGradient.
Eigen::VectorXd LogScaleNormGradient(const FlatSurface& flat, const ConeTargets& targets,
                                     const AngleObjective& objective, int power);

/// V: those u_f in the mean around every vertex, by area.
Eigen::VectorXd VertexLogScale(const FlatSurface& flat);

}  // namespace cirque
