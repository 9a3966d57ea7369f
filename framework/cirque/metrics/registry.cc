#include "cirque/metrics/measures.h"

namespace cirque {

const Registry<DistortionMeasure>& DistortionMeasures() {
  static const Registry<DistortionMeasure> kTable(
      "distortion measure", {
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
