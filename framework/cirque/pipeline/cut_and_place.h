#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/cone_file.h"
#include "cirque/pipeline/flat_surface.h"
#include "cirque/pipeline/options.h"
#include "cirque/pipeline/parameterization.h"

namespace cirque {

struct SolvedLayout;

/// What is parameterized, and how.
struct ParameterizeJob {
  const IntrinsicSurface& surface;
  const FileVertices& file;
  const Cut* cut;  ///< what is to be opened at least; null: a short one is sought
  const ParameterizeOptions& options;
  const SolveControl& control;
  const std::vector<bool>* inside = nullptr;  ///< E: edges no seam may run along; null: none
  const std::vector<Eigen::Vector3d>* position = nullptr;  ///< V; null: a metric without points
  const PrescribedRotations* rotations = nullptr;          ///< along loops; null: any
  bool targets_given = false;                              ///< the angle sums are the caller's own
  const std::function<Status(SolvedLayout*)>* place_exact = nullptr;  ///< null: it stays
  DualFit dual = DualFit::kFirst;                                     ///< as in FlattenJob
  /// Faces to be laid out each by itself, and others where doubles do not hold them about one origin
  /// (LayOutAboutSeveralOrigins); null: all about one.
  const std::vector<Index>* alone = nullptr;
  bool measure_visibility = true;  ///< as in ParameterizeRequest
};

/// The given cut and what is needed beyond it to open all cones and leave disks, as many as the
/// options ask for at least, short by the costs that they name, and never inside a polygon.
StatusOr<Cut> ChooseCut(const ParameterizeJob& job, const InputChart& flat,
                        const std::vector<Index>& cones);

/// Cuts result's flat surface, as it is on the job's triangles, along the given cut and where that
/// leaves no disks or cones inside, further; lays it out and refines it, several patches side by
/// side in the unit square. Fills in cut, uv and the certificate's layout, seams and
/// map_refinement. Beside an exact map (result's flat.exact) triangles of the flat surface or of its
/// layout may be flipped, which is not refined then. A disk whose conformal map
/// doubles do not hold is refined from EmbedInDisk where its refinement leaves conformality. One patch
/// that is injective stays so in its refinement where the options ask for it. Errors:
/// kUnrepresentable for a layout with a flipped triangle elsewhere; cancelled.
Status CutAndPlace(const ParameterizeJob& job, Parameterization* result);

/// What the certificate says of result's cut and seams, once more after the cut or the image changed.
void DescribeCut(const ParameterizeJob& job, Parameterization* result);

}  // namespace cirque
