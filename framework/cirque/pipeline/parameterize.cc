#include "cirque/pipeline/parameterize.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cirque/cones/boundaries.h"
#include "cirque/cones/cone.h"
#include "cirque/core/option.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/intrinsic/loop_rotations.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/fullest_map.h"
#include "cirque/pipeline/ladder.h"
#include "cirque/pipeline/lay_out.h"
#include "cirque/pipeline/prescribe_boundary.h"

namespace cirque {
namespace {

constexpr double kFlatness = 1e-6;  ///< [rad]: a vertex closer to 2 pi is no cone

using Job = ParameterizeJob;

/// Opens and lays out by the options' cut heuristic, or by all its candidates (MapFullest): what was
/// solved before is theirs together.
Status ByFullestCut(Status (*lay_out)(const Job&, Parameterization*), const Job& job,
                    Parameterization* result) {
  const auto by = [&](const ParameterizeOptions& options, Parameterization* map) {
    return lay_out({job.surface, job.file, job.cut, options, job.control, job.inside, job.position,
                    job.rotations, job.targets_given, job.place_exact, job.dual, job.alone,
                    job.measure_visibility},
                   map);
  };
  return MapFullest(job.options, by, result);
}

/// What follows on a flat metric.
Status Finish(const Job& job, Parameterization* result) {
  if (job.options.refine_cones > 0) {
    const Timer timer;
    job.control.BeginStage("refinement of cones");
    Status status = RefineCones({job.surface, result->targets, job.options, job.control},
                                &result->certificate, &result->targets, &result->flat);
    result->certificate.seconds.refine_cones = timer.Seconds();
    if (!status.ok()) return status;
  }
  return ByFullestCut(LayOutAndMeasure, job, result);
}

/// The number of cones that a heuristic was asked for; -1: none.
int ConesAskedFor(const ParameterizeOptions& options) {
  if (options.cone_budget >= 0) return options.cone_budget;
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(options.cones);
  if (!named.ok()) return -1;
  const auto given = named->options.find("cones");
  int count = -1;
  if (given == named->options.end()) return count;
  std::from_chars(given->second.data(), given->second.data() + given->second.size(), count);
  return count;
}

Status Place(const Job& job, const ConeSite& site, Parameterization* result) {
  const Timer timer;
  job.control.BeginStage("cones");
  StatusOr<ConeTargets> targets = job.options.holonomy == HolonomyRule::kFree
                                      ? PlaceCones(site, job.options)
                                      : PlaceSeamlessCones(site, job.options, job.control,
                                                           &Fill(&result->certificate.holonomy));
  result->certificate.seconds.cones = timer.Seconds();
  if (!targets.ok()) return targets.status();
  result->targets = *std::move(targets);
  return Status();
}

/// Notes where cones of a heuristic are more than were asked for, which they are where they must be.
void CompareWithBudget(const Triangulation& t, const ParameterizeOptions& options,
                       Parameterization* result) {
  const int asked = ConesAskedFor(options);
  if (asked < 0 || result->targets.lower.empty()) return;
  // The targets of a surface that was opened are about that one; its cones are counted before.
  const auto& layout = result->certificate.layout;
  const int placed = layout && layout->cones ? *layout->cones
                                             : static_cast<int>(ConesOf(t, result->targets).size());
  if (placed > asked) result->certificate.cone_budget = {asked, placed};
}

/// One road from a surface to its map.
Status TakeRoad(const Job& job, const Road& road, const ConeSite& site, Parameterization* result) {
  if (road.targets) {
    result->targets = *road.targets;
  } else if (OpensFirst(job)) {
    if (job.rotations) {
      return Status::InvalidInput(
          "rotations: across the free seams of a cut that is given without cones directions turn "
          "by any angle; take seams = rigid");
    }
    return ByFullestCut(OpenAndLayOut, job, result);
  } else if (Status s = Place(job, site, result); !s.ok()) {
    return s;
  }
  Status status = FlattenToTargets(job, result);
  return status.ok() ? Finish(job, result) : status;
}

/// What a surface is beside its metric.
struct Origin {
  FileVertices file;
  std::vector<bool> inside;  ///< E: edges inside polygons; empty: none
  const std::vector<Eigen::Vector3d>* position = nullptr;  ///< V; null: a metric without points
};

/// Whether rotations along loops may be asked for so.
Status CheckRotations(const ParameterizeRequest& request) {
  if (!request.rotations) return Status();
  const ParameterizeOptions& options = request.options;
  if (options.seams == SeamKind::kFree) {
    return Status::InvalidInput(
        "rotations: across free seams directions turn by any angle; take seams = rigid");
  }
  if (!request.rotations->meet) return Status();
  if (options.holonomy != HolonomyRule::kFree) {
    return Status::InvalidInput(
        "meet_rotations: holonomy says already what rotations are; leave out one of both");
  }
  if (options.pattern != PatternKind::kCircle) {
    return Status::InvalidInput("meet_rotations needs pattern = circle");
  }
  if (options.refine_cones > 0) {
    return Status::InvalidInput(
        "refine_cones changes cones' angles; with meet_rotations they stay: leave out one of both");
  }
  return Status();
}

/// Whether a surface may be parameterized so.
Status CheckRequest(const IntrinsicSurface& surface, const ParameterizeRequest& request) {
  const ParameterizeOptions& options = request.options;
  const Status fit =
      request.targets ? ParameterizeOptionTable().Validate(options) : CheckOptions(options);
  if (!fit.ok()) return fit;
  if (request.targets && options.boundary != kFreeBoundary &&
      !HasFreeBoundary(surface, *request.targets)) {
    return Status::InvalidInput("boundary: the targets prescribe it already; leave it free");
  }
  if (options.exact && options.injective) {
    return Status::InvalidInput(
        "exact: its seams are chosen before the image can be made injective; leave out exact or "
        "injective");
  }
  if (options.exact && options.least_charts > 1) {
    return Status::InvalidInput(
        "exact: its seams run along edges of the triangulation that is solved on, charts along "
        "those of the surface; leave out exact or least_charts");
  }
  if (Status s = CheckRotations(request); !s.ok()) return s;
  const std::vector<bool>& boundary = surface.boundary;
  if (options.integer_cells > 0 &&
      std::find(boundary.begin(), boundary.end(), true) != boundary.end()) {
    return Status::InvalidInput(
        "integer_cells: the surface has a boundary, which no lattice is made to follow; leave it "
        "out");
  }
  return Status();
}

Status RunRequest(const IntrinsicSurface& surface, const Origin& origin,
                  const ParameterizeRequest& request, const SolveControl& control,
                  Parameterization* result) {
  *result = Parameterization();
  const ParameterizeOptions& options = request.options;
  if (Status s = CheckRequest(surface, request); !s.ok()) return s;
  const Cut* cut = request.cut ? &*request.cut : nullptr;
  const ConeSite site(surface, origin.file);
  const auto take = [&](const Road& road, Parameterization* end) {
    return TakeRoad({surface, origin.file, cut, road.options, control,
                     origin.inside.empty() ? nullptr : &origin.inside, origin.position,
                     request.rotations.get(), request.targets.has_value(), &request.place_exact,
                     road.dual, nullptr, request.measure_visibility},
                    road, site, end);
  };
  const Road asked{options, request.targets, {}};
  const bool opens =
      cut != nullptr || (options.least_charts > 1 && options.seams != SeamKind::kRigid);
  Status status = ClimbLadder({site, asked, opens}, take, result);
  result->certificate.infeasibility = std::move(result->flat.infeasibility);
  result->certificate.cone_rounding = request.cone_rounding;
  if (!request.targets) CompareWithBudget(surface.triangulation, options, result);
  return status;
}

/// The angle sums of a metric, cones being what differs from flat by more than rounding.
ConeTargets MeasuredTargets(const IntrinsicSurface& surface) {
  ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
  const std::vector<double> sum = VertexAngleSums(surface.triangulation, surface.angles);
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    const bool cone = !surface.boundary[v] && std::abs(sum[v] - 2 * kPi) > kFlatness;
    if (cone) targets.lower[v] = targets.upper[v] = sum[v];
  }
  return targets;
}

/// Isolated vertices behind the last used one are unknown here, and no cone can lie there.
FileVertices VerticesInFile(const Surface& surface) {
  const auto& number = surface.soup_vertex;
  return {number.empty() ? 0 : *std::max_element(number.begin(), number.end()) + 1, number};
}

/// Whether a cut opens no polygon.
Status CheckKeepsPolygons(const Surface& surface, const std::vector<bool>& inside, const Cut& cut) {
  std::vector<int> opened;
  for (Index e = 0; e < surface.triangulation.num_edges(); ++e) {
    if (!inside[e] || !cut.edge[e]) continue;
    opened.push_back(
        surface.soup_polygon[Triangulation::Face(surface.triangulation.edge_halfedge[e])]);
  }
  std::sort(opened.begin(), opened.end());
  opened.erase(std::unique(opened.begin(), opened.end()), opened.end());
  if (opened.empty()) return Status();
  return Status::InvalidInput(fmt::format(
      "the cut runs through the inside of faces {} (0-based); lead it along their sides",
      IdList(opened)));
}

}  // namespace

StatusOr<ConeTargets> DefaultTargets(const Surface& surface) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  return DefaultTargets(ConeSite(MeasureSurface(surface.triangulation, lengths)));
}

Status Parameterize(const Triangulation& t, const EdgeLengths& lengths,
                    const ParameterizeRequest& request, const SolveControl& control,
                    Parameterization* result) {
  const Timer timer;
  const Origin origin{VerticesInOrder(t.num_vertices), {}};
  return Conclude(RunRequest(MeasureSurface(t, lengths), origin, request, control, result), timer,
                  &result->certificate);
}

Status Parameterize(const Surface& surface, const ParameterizeRequest& request,
                    const SolveControl& control, Parameterization* result) {
  const Timer timer;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const Origin origin{VerticesInFile(surface), EdgesInsidePolygons(surface), &surface.position};
  IntrinsicSurface intrinsic = MeasureSurface(surface.triangulation, lengths);
  MeasureNeedles(surface, &intrinsic.angles);
  Status status = request.cut ? CheckKeepsPolygons(surface, origin.inside, *request.cut) : Status();
  if (status.ok()) status = RunRequest(intrinsic, origin, request, control, result);
  NumberAsInFile(surface, &result->certificate.infeasibility);
  return Conclude(status, timer, &result->certificate);
}

Status LayOutFlatMetric(const Triangulation& t, const EdgeLengths& lengths, const Cut* cut,
                        Parameterization* result) {
  *result = Parameterization();
  const Timer timer;
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  FlatSurface& flat = result->flat;
  flat.intrinsic = {t, lengths, {}, {}};
  flat.intrinsic_lengths = lengths;
  flat.on_input = {surface.angles, lengths, {}};
  result->targets = MeasuredTargets(surface);
  const FileVertices file = VerticesInOrder(t.num_vertices);
  ParameterizeOptions plain;
  plain.refine_map = "none";
  const SolveControl control;
  return Conclude(LayOutAndMeasure({surface, file, cut, plain, control}, result), timer,
                  &result->certificate);
}

}  // namespace cirque
