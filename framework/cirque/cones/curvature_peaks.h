#pragma once

#include "cirque/cones/cone_heuristic.h"
#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

struct CurvaturePeaksOptions : ConeBudget {
  double share = 0;  ///< of all |K|, which the cones shall carry however many they are; 0: none
};

const OptionTable<CurvaturePeaksOptions>& CurvaturePeaksOptionTable();

/// Cones where the surface itself is most curved (the tenth of the vertices with the greatest |K|,
/// at least eight a cone while they are about as curved), far from one another, with the curvatures
/// of least distortion. Says nothing about the distortion: the baseline of the others. Without a
/// budget: the cones of SimpleConeTargets, whose angles are multiples of pi/2. With a share: those
/// of ConesAtCurvedVertices, as many as these are.
class CurvaturePeaks final : public BudgetedHeuristic {
 public:
  explicit CurvaturePeaks(const CurvaturePeaksOptions& options)
      : BudgetedHeuristic(options),
        simple_(options.cones < 0 && options.target == 0),
        share_(options.share) {}

 protected:
  StatusOr<std::vector<Cone>> ChooseAtMost(const ConeProblem& problem, int count) const override;

 private:
  bool simple_;
  double share_;
};

/// A simple valid set of cones for a closed surface: the curvature 2 pi chi that Gauss-Bonnet asks
/// for in equal parts on few vertices, far from each other and where the surface itself has much
/// curvature of that sign; every other vertex is flat.
///
/// The curvature comes in parts of pi/2 (cones of 3/2 pi for the sphere, of 5/2 pi for genus 2 and
/// more; none for the torus), or of pi, 2 pi or 4 pi where smaller parts would leave fewer than 8
/// vertices a cone or not find enough vertices with half a corner to spare for such an angle. Sums
/// of the angles are exact in multiples of pi/2. Surfaces with a boundary need no cones:
/// FreeBoundaryTargets. Deterministic.
///
/// Gauss-Bonnet and the corners are necessary for coherent angles, not sufficient: meshes of
/// mechanical parts with many handles can still turn out infeasible with these cones.
///
/// Errors (invalid input): too few vertices with enough corners for the genus.
StatusOr<ConeTargets> SimpleConeTargets(const IntrinsicSurface& surface);

}  // namespace cirque
