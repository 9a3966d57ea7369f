#include "cirque/pipeline/measure_map.h"

#include "cirque/metrics/distortion.h"
#include "cirque/metrics/injectivity.h"

namespace cirque {

void MeasureMap(const Triangulation& t, const EdgeLengths& lengths, Parameterization* result) {
  const Triangulation opened = CutOpen(t, result->cut);
  Certificate& certificate = result->certificate;
  certificate.overlap =
      BoundaryCrossings(opened, result->uv).empty() ? "injective" : "boundary_overlaps";
  const DistortionSummary d = Summarize(MeasureDistortion(t, lengths, result->uv));
  certificate.values.merge(
      std::map<std::string, double>{{"quasi_conformal_mean", d.quasi_conformal_mean},
                                    {"quasi_conformal_max", d.quasi_conformal_max},
                                    {"log_area_ratio_l2", d.log_area_ratio_l2},
                                    {"log_area_ratio_min", d.log_area_ratio_min},
                                    {"log_area_ratio_max", d.log_area_ratio_max}});
}

Status Conclude(const Status& status, const Timer& timer, Certificate* certificate) {
  certificate->seconds["total"] = timer.Seconds();
  certificate->outcome = ToString(status.code());
  certificate->message = status.message();
  return status;
}

void NumberAsInFile(const Surface& surface, InfeasibilityProof* proof) {
  for (Index& v : proof->constrained_vertex) v = surface.soup_vertex[v];
  for (Index& v : proof->carrying_vertices) v = surface.soup_vertex[v];
}

}  // namespace cirque
