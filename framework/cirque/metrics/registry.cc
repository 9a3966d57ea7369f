#include "cirque/metrics/registry.h"

#include "cirque/metrics/angle_distortion.h"
#include "cirque/metrics/angle_error.h"
#include "cirque/metrics/area_discrepancy.h"
#include "cirque/metrics/area_distortion.h"
#include "cirque/metrics/cut_length.h"
#include "cirque/metrics/degenerate.h"
#include "cirque/metrics/flipped.h"
#include "cirque/metrics/log_area_ratio.h"
#include "cirque/metrics/log_scale.h"
#include "cirque/metrics/overlap.h"
#include "cirque/metrics/quasi_conformal.h"
#include "cirque/metrics/resolution.h"
#include "cirque/metrics/singular_values.h"
#include "cirque/metrics/symmetric_dirichlet.h"

namespace cirque {

const Registry<DistortionMeasure>& DistortionMeasures() {
  static const Registry<DistortionMeasure> kTable(
      "metric", {
                    {"quasi_conformal", QuasiConformal()},
                    {"angle_error", AngleError()},
                    {"angle_distortion", AngleDistortion()},
                    {"log_area_ratio", LogAreaRatio()},
                    {"log_scale", LogScale()},
                    {"area_distortion", AreaDistortion()},
                    {"area_discrepancy", AreaDiscrepancy()},
                    {"symmetric_dirichlet", SymmetricDirichlet()},
                    {"singular_value_min", SmallerSingularValue()},
                    {"singular_value_max", LargerSingularValue()},
                    {"resolution", Resolution()},
                    {"cut", CutLength()},
                    {"flipped", Flipped()},
                    {"overlap", Overlap()},
                    {"degenerate", Degenerate()},
                });
  return kTable;
}

}  // namespace cirque
