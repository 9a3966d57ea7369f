#include "cirque/domains/sphere_placement.h"

#include <utility>

#include "cirque/domains/refine_on_shape.h"
#include "cirque/domains/sphere_refinement.h"
#include "cirque/metrics/injectivity.h"

namespace cirque {

SpherePlacement::SpherePlacement(const Surface& surface, const EdgeLengths& lengths,
                                 const DomainOptions& options, std::string refine_map,
                                 const SolveControl& control, SurfaceMap* map)
    : surface_(surface),
      lengths_(lengths),
      options_(options),
      refine_map_(std::move(refine_map)),
      control_(control),
      map_(*map) {}

Status SpherePlacement::Place(PlaneWithPole plane) {
  const Status status = Normalize(plane);
  const bool refine = status.ok() && flipped_.empty() && refine_map_ != "none";
  return refine ? RefineThenNormalize(std::move(plane)) : status;
}

Status SpherePlacement::RefineThenNormalize(PlaneWithPole plane) {
  const PlaneWithPole before = plane;
  control_.BeginStage("refinement");
  Status status =
      RefineOnSphere(surface_.triangulation, lengths_, chart_,
                     RefinementOnShape(refine_map_, map_.certificate.layout->layout_closure),
                     control_.cancelled, &plane, &map_.certificate.map_refinement);
  if (!status.ok()) return status;
  status = Normalize(plane);
  return status.ok() && flipped_.empty() ? status : Normalize(before);
}

Status SpherePlacement::Normalize(const PlaneWithPole& plane) {
  const auto normalized = NormalizeChart(surface_, plane, options_.normalization);
  normalized_ = normalized.ok();
  if (!normalized_) return normalized.status();
  chart_ = normalized->chart;
  SphereSummary& summary = Fill(&map_.certificate.sphere);
  summary.normalization_iterations = normalized->iterations;
  summary.normalization_residual = normalized->residual;
  map_.position = LiftAll(surface_, plane, normalized->chart, options_.principal_axes);
  Eigen::Vector3d mass = Eigen::Vector3d::Zero();
  for (std::size_t v = 0; v < map_.position.size(); ++v) {
    mass += normalized->weights[v] * map_.position[v];
  }
  summary.centre_of_mass = mass.norm();
  FindFlipped();
  return Status();
}

void SpherePlacement::FindFlipped() {
  flipped_ = FlippedSphericalFaces(surface_.triangulation, map_.position);
  Fill(&map_.certificate.layout).flipped_triangles = static_cast<int>(flipped_.size());
}

}  // namespace cirque
