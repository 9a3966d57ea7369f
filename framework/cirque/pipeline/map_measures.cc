#include "cirque/pipeline/map_measures.h"

#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/measure_map.h"

namespace cirque {
namespace {

std::string ToString(BoundaryContact contact) {
  switch (contact) {
    case BoundaryContact::kApart:
      return "injective";
    case BoundaryContact::kTouch:
      return "boundary_touches";
    case BoundaryContact::kCrossing:
      return "boundary_overlaps";
  }
  return "unknown";
}

}  // namespace

void MeasureDistortion(const Triangulation& t, const EdgeLengths& lengths,
                       Parameterization* result) {
  const Triangulation opened = CutOpen(t, result->cut);
  result->certificate.overlap = ToString(FindBoundaryContact(opened, result->uv));
  result->certificate.distortion = DistortionOf(t, lengths, result->uv);
}

DistortionSummary DistortionOf(const Triangulation& t, const EdgeLengths& lengths,
                               const CornerUv& uv) {
  const auto figures =
      MeasureFigures(t, lengths, uv,
                     {"quasi_conformal_mean", "quasi_conformal_max", "log_area_ratio_l2",
                      "log_area_ratio_min", "log_area_ratio_max"});
  return {figures->at("quasi_conformal_mean"), figures->at("quasi_conformal_max"),
          figures->at("log_area_ratio_l2"), figures->at("log_area_ratio_min"),
          figures->at("log_area_ratio_max")};
}

}  // namespace cirque
