#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/opened_map.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/seams.h"
#include "cirque/layout/sliding.h"
#include "cirque/pipeline/certificate.h"

namespace cirque {

/// What ParameterizeOptions::refine_map may name: "auto" (RefineByPatches), "none", objectives of
/// RefineMap and energies of RefineStretch.
std::vector<std::string> RefineMapNames();

/// Whether a text is a value of ParameterizeOptions::refine_map; the error says what is wrong.
Status CheckRefineMap(const std::string& refine_map);

/// Whether it names an energy of both singular values, which wants a boundary that may move.
bool LeavesConformal(const std::string& refine_map);

/// A layout's surface, flat metric, cut and cones.
struct LaidOutSurface {
  const IntrinsicSurface& surface;
  const InputChart& flat;
  const Cut& cut;
  const std::vector<Index>& cones;
  const std::atomic<bool>* cancelled;
  bool injective = false;  ///< the layout is, and its refinement shall stay so
};

/// Refines a layout without flipped faces as `refine_map` says, unless that is "none". Boundary
/// vertices whose angle sums `targets` prescribe stay, and their neighbours on the boundary, so that
/// polygons stay polygons; on a surface without a cut those of angle pi between two that stay slide
/// along their straight side. Errors: as CheckRefineMap; cancelled.
Status RefineLayout(const LaidOutSurface& of, const ConeTargets& targets,
                    const std::string& refine_map, PlanarLayout* layout,
                    std::optional<MapRefinementSummary>* summary);

/// What of a map's vertices a refinement may not move as it likes.
struct KeptVertices {
  std::vector<bool> held;  ///< V; empty: none
  SlidingVertices sliding = {};
};

/// The same of a map without a cut.
Status RefineHeldMap(const IntrinsicSurface& surface, KeptVertices kept,
                     const std::string& refine_map, const std::atomic<bool>* cancelled,
                     CornerUv* uv, std::optional<MapRefinementSummary>* summary);

/// The same of a map whose seams lie along its cut (MeasureSeams). Where triangles would turn more
/// than once round a vertex (WoundVertices) the map stays as it was.
Status RefineSeamedMap(const SeamedSurface& of, const std::string& refine_map,
                       const std::atomic<bool>* cancelled, CornerUv* uv,
                       std::optional<MapRefinementSummary>* summary);

/// The seams' figures for a certificate.
SeamSummary SummaryOf(const SeamReport& report);

/// 4 where every cone's angle is fixed to a multiple of pi/2, 6 where to one of pi/3, 0 otherwise.
/// 4 without cones: the transitions of a flat surface without handles and loops, and of a flat
/// torus, then are translations.
int CommonRotationOrder(const ConeTargets& targets, const std::vector<Index>& cones);

/// Makes the rotations across all seams exact multiples of 2 pi / order, and the two sides of every
/// seam differ by just that and a translation. False, with `uv` untouched, where some rotation is
/// no multiple, as around a handle or a boundary loop it need not be, or where exactness would
/// flip a triangle.
bool SnapRotations(const Triangulation& triangulation, const Cut& cut,
                   const std::vector<Index>& cones, const CornerAngles& flat_angles, int order,
                   CornerUv* uv);

/// Gives the image of every piece of a surface that was opened into several the area that the piece
/// has: each has a scale of its own otherwise. Of one piece the image stays.
void ScalePieces(const IntrinsicSurface& surface, PlanarLayout* layout);

/// Several patches, each in a frame of its own: side by side in the unit square. One patch: exact
/// rotations across the seams (SnapRotations) where the cones' angles allow it. Returns their order,
/// 0 where they are not exact.
int ArrangePatches(const LaidOutSurface& of, const ConeTargets& targets, PlanarLayout* layout);

/// Fills in the certificate's overlap and figures of distortion.
void MeasureDistortion(const Triangulation& triangulation, const EdgeLengths& lengths,
                       const Cut& cut, const CornerUv& uv, Certificate* certificate);

/// The certificate's figures of distortion of a map of flat triangles.
DistortionSummary DistortionOf(const Triangulation& triangulation, const EdgeLengths& lengths,
                               const CornerUv& uv);

}  // namespace cirque
