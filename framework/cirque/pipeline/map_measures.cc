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

void PutMeasures(const Triangulation& t, const EdgeLengths& lengths, Parameterization* result) {
  const Triangulation opened = CutOpen(t, result->cut);
  Certificate& certificate = result->certificate;
  certificate.overlap = ToString(FindBoundaryContact(opened, result->uv));
  certificate.values.merge(
      *MeasureFigures(t, lengths, result->uv,
                      {"quasi_conformal_mean", "quasi_conformal_max", "log_area_ratio_l2",
                       "log_area_ratio_min", "log_area_ratio_max"}));
}

Status Conclude(const Status& status, const Timer& timer, Certificate* certificate) {
  certificate->seconds["total"] = timer.Seconds();
  certificate->outcome = ToString(status.code());
  certificate->message = status.message();
  return status;
}

void NumberAsInFile(const Surface& surface, InfeasibilityCertificate* proof) {
  for (Index& v : proof->constrained_vertex) v = surface.soup_vertex[v];
  for (Index& v : proof->carrying_vertices) v = surface.soup_vertex[v];
}

}  // namespace cirque
