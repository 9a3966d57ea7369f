#include "cirque/pipeline/parameterize.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cirque/angles/registry.h"
#include "cirque/angles/targets.h"
#include "cirque/core/text.h"
#include "cirque/core/timer.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/mesh/corner_angles.h"
#include "cirque/metrics/distortion.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/radii/solve_log_radii.h"

namespace cirque {
namespace {

Status RequireDisk(const Triangulation& t) {
  const auto loops = BoundaryLoops(t).size();
  if (EulerCharacteristic(t) == 1 && loops == 1) return Status();
  return Status::InvalidInput(fmt::format(
      "the surface is not a disk: genus {}, {} boundary loops; cut it into a disk first",
      (2 - static_cast<int>(loops) - EulerCharacteristic(t)) / 2, loops));
}

/// One run: what the stages hand on, and their evidence.
class Run {
 public:
  Run(const Surface& surface, const ConeTargets& targets, const ParameterizeOptions& options,
      const SolveControl& control, Parameterization* result)
      : surface_(surface),
        t_(surface.triangulation),
        targets_(targets),
        options_(options),
        control_(control),
        result_(*result),
        certificate_(result->certificate) {}

  Status Execute() {
    if (Status s = RequireDisk(t_); !s.ok()) return s;
    lengths_ = MeasureEdgeLengths(surface_);
    if (Status s = Timed("angles", &Run::FitAngles); !s.ok()) return s;
    if (Status s = Timed("radii", &Run::SolveRadii); !s.ok()) return s;
    if (Status s = Timed("layout", &Run::LayOut); !s.ok()) return s;
    return Timed("measures", &Run::Measure);
  }

 private:
  Status Timed(const char* stage, Status (Run::*step)()) {
    const Timer timer;
    Status status = (this->*step)();
    certificate_.seconds[stage] = timer.Seconds();
    return status;
  }

  OptionMap SolverOptions() const {
    return {{"max_iterations", std::to_string(options_.max_iterations)}};
  }

  Status FitAngles() {
    const auto objective = AngleObjectives().Find(options_.angle_fit);
    if (!objective.ok()) return objective.status();
    const auto method = MakeAngleFitMethod(options_.angle_strategy, SolverOptions());
    if (!method.ok()) return method.status();
    if (Status s = CheckTargets(t_, targets_, &certificate_.infeasibility); !s.ok()) return s;
    const AngleConstraints constraints(t_, targets_);
    const CornerAngles reference = MeasureCornerAngles(t_, lengths_);
    AngleFitResult fit;
    Status status = cirque::FitAngles({constraints, reference.value, options_.epsilon}, *objective,
                                      **method, control_, &fit);
    certificate_.infeasibility = std::move(fit.infeasibility);
    Record("angle", fit.solve);
    Put({{"smallest_angle", fit.kkt.smallest_angle},
         {"smallest_theta", fit.kkt.smallest_theta},
         {"epsilon", fit.angles.epsilon},
         {"triangle_sum_residual", fit.kkt.triangle_sum_residual},
         {"vertex_sum_residual", fit.kkt.vertex_sum_residual},
         {"angle_primal", fit.kkt.primal},
         {"angle_dual", fit.kkt.dual},
         {"angle_gap", fit.kkt.RelativeGap()}});
    result_.angles = std::move(fit.angles);
    return status;
  }

  Status SolveRadii() {
    const auto strategy = MakeSolverStrategy(options_.strategy, SolverOptions());
    if (!strategy.ok()) return strategy.status();
    LogRadiiResult radii;
    Status status = SolveLogRadii(t_, result_.angles, **strategy, control_, &radii);
    Record("radii", radii.solve);
    certificate_.values["radii_factorizations"] += radii.start_iterations;
    Put({{"radii_gradient", radii.gradient_max},
         {"radii_primal", radii.energy},
         {"radii_dual", radii.dual_energy},
         {"radii_gap", radii.RelativeGap()},
         {"log_radius_range",
          radii.log_radii.value.maxCoeff() - radii.log_radii.value.minCoeff()}});
    result_.log_radii = std::move(radii.log_radii);
    return status;
  }

  Status LayOut() {
    const CornerAngles flat = FlatCornerAngles(t_, result_.angles, result_.log_radii);
    ScaleToSurfaceArea(flat);
    PlanarLayout layout =
        LayOutByDirections(t_, flat, FlatEdgeLengths(t_, flat, result_.log_radii));
    Put({{"layout_closure", layout.closure}});
    const std::vector<Index> flipped = FlippedFaces(t_, layout.uv);
    Put({{"flipped_triangles", static_cast<double>(flipped.size())}});
    if (!flipped.empty()) return Unrepresentable(flipped);
    result_.uv = std::move(layout.uv);
    return Status();
  }

  Status Measure() {
    certificate_.overlap =
        BoundaryCrossings(t_, result_.uv).empty() ? "injective" : "boundary_overlaps";
    const DistortionSummary d = Summarize(MeasureDistortion(t_, lengths_, result_.uv));
    Put({{"quasi_conformal_mean", d.quasi_conformal_mean},
         {"quasi_conformal_max", d.quasi_conformal_max},
         {"log_area_ratio_l2", d.log_area_ratio_l2},
         {"log_area_ratio_min", d.log_area_ratio_min},
         {"log_area_ratio_max", d.log_area_ratio_max}});
    return Status();
  }

  /// Shifts the gauge so that the image has the surface's area.
  void ScaleToSurfaceArea(const CornerAngles& flat) {
    const CornerAngles source = MeasureCornerAngles(t_, lengths_);
    double image_area = 0, source_area = 0;
    for (Index f = 0; f < t_.num_faces(); ++f) {
      const double radius = std::exp(result_.log_radii.value[f]);
      double image = 2 * radius * radius;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) image *= std::sin(flat.value[h]);
      image_area += image;
      source_area += 0.5 * lengths_.value[t_.edge[3 * f]] * lengths_.value[t_.edge[3 * f + 1]] *
                     std::sin(source.value[3 * f + 2]);
    }
    result_.log_radii.value.array() += 0.5 * std::log(source_area / image_area);
  }

  Status Unrepresentable(const std::vector<Index>& flipped) const {
    return Status(
        StatusCode::kUnrepresentable,
        fmt::format(
            "the flat metric exists but doubles cannot hold it in one chart: log radii range "
            "over {:.1f} and {} faces collapse, faces {} (0-based) among them; add cones there",
            certificate_.values.at("log_radius_range"), flipped.size(), IdList(flipped, 5)));
  }

  void Record(const std::string& stage, const SolveSummary& solve) {
    Put({{stage + "_iterations", solve.num_iterations()},
         {stage + "_factorizations", solve.factorizations}});
  }

  void Put(const std::map<std::string, double>& values) {
    certificate_.values.insert(values.begin(), values.end());
  }

  const Surface& surface_;
  const Triangulation& t_;
  const ConeTargets& targets_;
  const ParameterizeOptions& options_;
  const SolveControl& control_;
  Parameterization& result_;
  Certificate& certificate_;
  EdgeLengths lengths_;
};

/// Renumbers the proof's vertices and faces as the input file has them.
void NumberAsInFile(const Surface& surface, InfeasibilityProof* proof) {
  for (Index& v : proof->constrained_vertex) v = surface.soup_vertex[v];
  for (Index& v : proof->carrying_vertices) v = surface.soup_vertex[v];
}

}  // namespace

Status Parameterize(const Surface& surface, const ConeTargets& targets,
                    const ParameterizeOptions& options, const SolveControl& control,
                    Parameterization* result) {
  *result = Parameterization();
  const Timer timer;
  const Status status = Run(surface, targets, options, control, result).Execute();
  Certificate& certificate = result->certificate;
  certificate.seconds["total"] = timer.Seconds();
  certificate.outcome = ToString(status.code());
  certificate.message = status.message();
  NumberAsInFile(surface, &certificate.infeasibility);
  return status;
}

}  // namespace cirque
