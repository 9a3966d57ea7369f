#include "cirque/domains/exact_sphere.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/solve_summary.h"
#include "cirque/domains/refine_on_shape.h"
#include "cirque/domains/sphere_refinement.h"
#include "cirque/intrinsic/overlay.h"
#include "cirque/intrinsic/straight_lines.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/pipeline/exact_layout.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

/// The refined map where that flips no triangle that was solved on, else the one given.
StatusOr<Positions> Refined(const Surface& surface, const IntrinsicTriangulation& solved,
                            const DomainOptions& shape, const std::string& refine_map,
                            const SphereChart& chart, PlaneWithPole plane,
                            const std::atomic<bool>* cancelled, Positions before) {
  std::optional<MapRefinementSummary> unused;
  const Status status = RefineOnSphere(solved.triangulation, solved.lengths, chart, refine_map,
                                       cancelled, &plane, &unused);
  if (!status.ok()) return status;
  const auto normalized = NormalizeChart(surface, plane, shape.normalization);
  if (!normalized.ok()) return before;
  Positions after = LiftAll(surface, plane, normalized->chart, shape.principal_axes);
  const bool good = FlippedSphericalFaces(solved.triangulation, after).empty();
  return good ? std::move(after) : std::move(before);
}

Status CheckNotFlipped(const Triangulation& solved, const Positions& position) {
  const std::size_t flipped = FlippedSphericalFaces(solved, position).size();
  if (flipped == 0) return Status();
  return Status(
      StatusCode::kUnrepresentable,
      fmt::format(
          "the exact map: {} of the triangulation that was solved on {} flipped where their "
          "corners go; the plane may hold it (-cones=greedy)",
          Count(flipped, "triangle"), flipped == 1 ? "is" : "are"));
}

Status Draw(const Triangulation& t, const IntrinsicTriangulation& solved, const Positions& position,
            int limit, SurfaceMap* map) {
  const IntrinsicSurface surface = MeasureSurface(solved.triangulation, solved.lengths);
  const StatusOr<Overlay> overlay =
      MakeOverlay(t, solved.flips, StraightLines(surface.triangulation, surface.lengths), limit);
  if (!overlay.ok()) return overlay.status().In("exact_limit");
  const Cut none{std::vector<bool>(solved.triangulation.num_edges(), false)};
  const CornerUv chords = FacesInPlane(
      MeasureSurface(solved.triangulation, ChordLengths(solved.triangulation, position)));
  SolvedMap drawn = {t, surface, none, chords};
  drawn.on_sphere = &position;
  ExactMapSummary& summary = Fill(&map->certificate.exact_map);
  ExactMap exact;
  if (Status s = DrawExactMap(drawn, *overlay, &summary, &exact); !s.ok()) return s;
  Summarize(DistortionOf(surface.triangulation, surface.lengths, chords), &summary);
  map->exact_map = std::move(exact);
  return Status();
}

}  // namespace

Status MakeExactOnSphere(const Surface& surface, const IntrinsicTriangulation& solved,
                         const DomainOptions& shape, const ParameterizeOptions& options,
                         const PlaneWithPole& plane, const std::atomic<bool>* cancelled,
                         SurfaceMap* map) {
  const auto normalized = NormalizeChart(surface, plane, shape.normalization);
  if (!normalized.ok()) return normalized.status();
  Positions position = LiftAll(surface, plane, normalized->chart, shape.principal_axes);
  if (Status s = CheckNotFlipped(solved.triangulation, position); !s.ok()) return s;
  if (options.refine_map != "none") {
    const std::string refine_map =
        RefinementOnShape(options.refine_map, map->certificate.layout->layout_closure);
    auto refined = Refined(surface, solved, shape, refine_map, normalized->chart, plane, cancelled,
                           std::move(position));
    if (!refined.ok()) return refined.status();
    position = *std::move(refined);
  }
  return Draw(surface.triangulation, solved, position, options.exact_limit, map);
}

std::vector<Eigen::Vector3d> PlacesOfVertices(const ExactMap& map, Index num_vertices) {
  return {map.position.begin(), map.position.begin() + num_vertices};
}

}  // namespace cirque
