#pragma once

#include <optional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/exact_map.h"
#include "cirque/pipeline/cut_and_place.h"
#include "cirque/pipeline/parameterization.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

struct Overlay;

/// The layout of the triangulation that was solved on, before its exact map is drawn.
struct SolvedLayout {
  const IntrinsicSurface& surface;  ///< in the input's metric, of conformal equivalence flat; the
                                    ///< vertices are the input's
  const CornerAngles& angles;       ///< flat
  Cut cut;                          ///< of it
  CornerUv uv;
  ExactMapSummary& summary;      ///< what the certificate says of it
  bool is_circle_pattern;        ///< else a refinement would have nothing to compare it with
  std::optional<int> grid = {};  ///< of the places on the cut (MakeExactMap); nothing: none
  /// As in SolvedMap.
  const std::vector<Index>* part_of = nullptr;
  Index num_wholes = 0;
};

/// Lays out the triangulation that was solved on (FlatSurface::exact) by itself, as CutAndPlace
/// does the job's surface, its seams along its own edges, and fills in result's exact_map, which is
/// linear on those triangles: no triangle of it is flipped, and no vertex was moved but by the job's
/// place_exact, which leaves none flipped. Given cuts stay where their edges do. What doubles do not
/// hold about one origin lies in patches about several, each a rigid piece of the flat metric, unless
/// place_exact needs one. Errors: as CutAndPlace, MakeExactMap and place_exact; kInvalidInput for an overlay above
/// ParameterizeOptions::exact_limit.
Status LayOutExactly(const ParameterizeJob& job, Parameterization* result);

/// A map of a triangulation that an input was flipped to.
struct SolvedMap {
  const Triangulation& input;
  const IntrinsicSurface& solved;  ///< that triangulation, in the input's metric
  const Cut& cut;                  ///< of it
  const CornerUv& uv;              ///< of it, no face flipped
  std::optional<int> grid = {};    ///< of the places on the cut (MakeExactMap)
  /// Per face of the input the one of the surface that it was cut from, of so many; null: itself.
  const std::vector<Index>* part_of = nullptr;
  Index num_wholes = 0;
  /// Where the vertices lie on the unit sphere, no face flipped (MakeExactSphereMap); null: `uv` says.
  const std::vector<Eigen::Vector3d>* on_sphere = nullptr;
};

/// Draws it on the overlay (MakeExactMap), and fills in what the certificate says of the two.
/// Errors: as MakeExactMap, with its ExactMapRepair::too_small.
Status DrawExactMap(const SolvedMap& of, const Overlay& overlay, ExactMapSummary* summary,
                    ExactMap* map, std::vector<Index>* too_small = nullptr);

/// The figures of distortion for the certificate.
void Summarize(const DistortionSummary& distortion, ExactMapSummary* summary);

/// Of an exact map's own triangles, each measured by itself.
DistortionSummary DistortionOf(const IntrinsicSurface& surface, const ExactMap& map);

}  // namespace cirque
