#include "cirque/domains/map_decimated.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/cones/boundaries.h"
#include "cirque/core/count.h"
#include "cirque/core/parallel.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/domains/atlas.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/opened_map.h"
#include "cirque/layout/packing.h"
#include "cirque/layout/relax_map.h"
#include "cirque/layout/seams.h"
#include "cirque/layout/undo_collapses.h"
#include "cirque/mesh/coarsen.h"
#include "cirque/mesh/preflight.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/cut_costs.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

/// Sweeps after the last doubling, and the share more of them after each before: they cost half as
/// much there, and take away what the next level no longer sees.
constexpr int kSweeps = 4;
constexpr double kMoreSweeps = 1.5;
constexpr int kMostSweeps = 40;

Status CheckRequest(const MapRequest& request) {
  const ParameterizeOptions& options = request.options;
  const char* what = request.targets                     ? "prescribed angle sums"
                     : request.cut                       ? "cut of your own"
                     : request.rotations                 ? "rotations along loops"
                     : options.exact                     ? "exact map"
                     : options.seams == SeamKind::kFree  ? "seams = free"
                     : options.boundary != kFreeBoundary ? "boundary shape"
                     : !options.edge_costs.empty()       ? "file of edge costs"
                                                         : nullptr;
  if (!what) return Status();
  return Status::InvalidInput(fmt::format(
      "solve_at takes no {}: the decimated mesh has other vertices; leave out one of both", what));
}

/// The corner angles of the triangles of a map.
CornerAngles AnglesIn(const CornerUv& uv) {
  CornerAngles angles{Eigen::VectorXd(static_cast<Eigen::Index>(uv.value.size()))};
  ParallelFor(static_cast<Index>(uv.value.size()), [&](Index h) {
    const Eigen::Vector2d a = uv.value[Triangulation::Next(h)] - uv.value[h];
    const Eigen::Vector2d b = uv.value[Triangulation::Prev(h)] - uv.value[h];
    angles.value[h] = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  });
  return angles;
}

/// One surface on its way down and back.
class DecimatedSolve {
 public:
  DecimatedSolve(const Surface& surface, const MapRequest& request, const SolveControl& control,
                 SurfaceMap* map)
      : surface_(surface),
        t_(surface.triangulation),
        request_(request),
        control_(control),
        map_(map) {}

  Status Run() {
    if (Status s = CheckRequest(request_); !s.ok()) return s;
    Decimate();
    Status status = MapCoarse();
    map_->certificate.seconds.decimate = seconds_decimate_;
    if (!status.ok()) return status;
    const Timer timer;
    status = CarryBack();
    if (status.ok()) status = Finish();
    map_->certificate.seconds.carry_back = timer.Seconds();
    if (!status.ok()) {
      map_->uv = {};
      return status;
    }
    Measure();
    return Status();
  }

 private:
  void Decimate() {
    control_.BeginStage("decimation");
    const Timer timer;
    coarse_ = Coarsen(surface_, request_.options.solve_at);
    seconds_decimate_ = timer.Seconds();
  }

  Status MapCoarse() {
    PreflightReport report;
    const StatusOr<Surface> coarse = Preflight(coarse_.soup, &report);
    if (!coarse.ok()) return coarse.status().In("the decimated surface");
    MapRequest request = request_;
    request.options.solve_at = 0;
    // Sides of seams that match are what the way back carries; descent to an injective image parts them.
    const bool may_part = request.options.injective && request.options.least_charts <= 1;
    if (may_part) request.options.seams = SeamKind::kRigid;
    StatusOr<SurfaceMap> solved = MapSurface(*coarse, request, control_, &map_->certificate);
    if (!solved.ok()) {
      map_->certificate.infeasibility = {};
      const Status& s = solved.status();
      const bool infeasible = s.code() == StatusCode::kInfeasible;
      return Status(infeasible ? StatusCode::kNotConverged : s.code(),
                    "the decimated surface has no map: " + s.message());
    }
    Begin(coarse->triangulation, *solved);
    map_->certificate = std::move(solved->certificate);
    DecimatedSolveSummary& summary = Fill(&map_->certificate.decimated_solve);
    summary.solved_faces = coarse->triangulation.num_faces();
    summary.collapses = static_cast<Index>(coarse_.collapses.size());
    return Status();
  }

  /// The map of the faces that are left, as one of the surface with its edges collapsed. Their
  /// corners are those of the soup, whose vertices are all of some face.
  void Begin(const Triangulation& coarse, const SurfaceMap& solved) {
    const std::size_t corners = t_.vertex.size();
    partial_.corner = std::move(coarse_.collapses.corner);
    partial_.there.assign(corners / 3, false);
    partial_.cut.assign(corners, false);
    partial_.uv.value.assign(corners, {0, 0});
    for (Index h = 0; h < coarse.num_halfedges(); ++h) {
      const Index in_surface = 3 * coarse_.face[h / 3] + h % 3;
      partial_.there[in_surface / 3] = true;
      partial_.uv.value[in_surface] = solved.uv.value[h];
      const Index e = coarse.edge[h];
      partial_.cut[in_surface] = !coarse.IsBoundaryEdge(e) && solved.cut.edge[e];
    }
    map_->targets = FreeBoundaryTargets(t_);
    for (const Index v : ConeVertices(BoundaryVertices(coarse), solved.targets)) {
      map_->targets.lower[coarse_.vertex[v]] = solved.targets.lower[v];
      map_->targets.upper[coarse_.vertex[v]] = solved.targets.upper[v];
    }
    vertices_ = static_cast<double>(coarse_.vertex.size());
    coarse_.soup = {};
  }

  /// How many times vertices double on the way back.
  int NumLevels() const {
    const auto all = static_cast<double>(surface_.position.size());
    return std::max(1, static_cast<int>(std::ceil(std::log2(all / vertices_))));
  }

  Status CarryBack() {
    Index& retreats = map_->certificate.decimated_solve->retreats;
    CollapseLog& log = coarse_.collapses;
    for (int level = NumLevels() - 1; level >= 0; --level) {
      control_.BeginStage("undoing collapses");
      const double doubled = std::exp2(-level) * static_cast<double>(surface_.position.size());
      const auto missing = static_cast<std::size_t>(std::max(0.0, doubled - vertices_));
      const std::size_t count = level == 0 ? log.size() : std::min(log.size(), missing);
      const StatusOr<Index> kept_off = UndoCollapses(surface_.position, count, &log, &partial_);
      if (!kept_off.ok()) return kept_off.status();
      retreats += *kept_off;
      vertices_ += static_cast<double>(count);
      control_.BeginStage("relaxation");
      const double sweeps = kSweeps * std::pow(kMoreSweeps, level);
      RelaxMap(surface_.position, static_cast<int>(std::min<double>(sweeps, kMostSweeps)),
               control_.cancelled, &partial_);
      if (control_.cancelled && *control_.cancelled) {
        return {StatusCode::kCancelled, "carrying the map back: interrupted"};
      }
    }
    map_->uv = std::move(partial_.uv);
    map_->cut.edge.assign(t_.num_edges(), false);
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (partial_.cut[h]) map_->cut.edge[t_.edge[h]] = true;
    }
    coarse_ = {};
    partial_ = {};
    return CheckOrientation();
  }

  /// Refines, and makes the seams' rotations exact again where the cones' angles allow it.
  Status Finish() {
    control_.BeginStage("refinement");
    const EdgeLengths lengths = MeasureEdgeLengths(surface_);
    const IntrinsicSurface intrinsic = MeasureSurface(t_, lengths);
    const std::vector<Index> cones = ConeVertices(intrinsic.boundary, map_->targets);
    const SeamedSurface of = {
        intrinsic, map_->cut,
        MeasureSeams(t_, map_->cut, cones, AnglesIn(map_->uv), map_->uv).seams};
    Status status = RefineSeamedMap(of, request_.options.refine_map, control_.cancelled, &map_->uv,
                                    &map_->certificate.map_refinement);
    if (!status.ok()) return status;
    Arrange();
    LayoutSummary& layout = Fill(&map_->certificate.layout);
    const int order = layout.rotation_order.value_or(0);
    const bool exact =
        order > 0 && SnapRotations(t_, map_->cut, cones, AnglesIn(map_->uv), order, &map_->uv);
    if (!exact) layout.rotation_order = 0;
    if (Status s = CheckOrientation(); !s.ok()) return s;
    map_->certificate.seams =
        SummaryOf(MeasureSeams(t_, map_->cut, cones, AnglesIn(map_->uv), map_->uv));
    layout.cut_length = RelativeCutLength(intrinsic, map_->cut);
    if (request_.measure_visibility) {
      layout.visible_cut_length = VisibleCutLength(intrinsic, surface_.position, map_->cut);
    }
    return Status();
  }

  Status CheckOrientation() const {
    const std::vector<Index> flipped = FlippedFaces(t_, map_->uv);
    Fill(&map_->certificate.layout).flipped_triangles = static_cast<int>(flipped.size());
    if (flipped.empty()) return Status();
    return Status(StatusCode::kUnrepresentable,
                  fmt::format("{} came back flipped", Count(flipped.size(), "triangle")));
  }

  /// Several patches, which have grown out of their places, side by side again. One gets the area of
  /// the surface, unless rounding flips something.
  void Arrange() const {
    const Patches patches = ConnectedPatches(CutOpen(t_, map_->cut));
    if (patches.count > 1) {
      map_->uv = PackPatches(map_->uv, patches, {}).uv;
      return;
    }
    const double scale = std::sqrt(AreaOf(surface_) / AreaOf(map_->uv));
    CornerUv scaled = map_->uv;
    for (Eigen::Vector2d& p : scaled.value) p *= scale;
    if (FlippedFaces(t_, scaled).empty()) map_->uv = std::move(scaled);
  }

  void Measure() const {
    control_.BeginStage("measures");
    const Timer timer;
    Certificate& certificate = map_->certificate;
    certificate.layout->float32_vanishing_triangles =
        static_cast<int>(FlippedFacesInFloat32(t_, map_->uv).size());
    MeasureDistortion(t_, MeasureEdgeLengths(surface_), map_->cut, map_->uv, &certificate);
    AddSeconds(timer, &certificate.seconds.measures);
  }

  const Surface& surface_;
  const Triangulation& t_;
  const MapRequest& request_;
  const SolveControl& control_;
  SurfaceMap* map_;
  CoarseSurface coarse_;
  CollapsedMap partial_;
  double vertices_ = 0;  ///< that are there
  double seconds_decimate_ = 0;
};

}  // namespace

Status MapDecimated(const Surface& surface, const MapRequest& request, const SolveControl& control,
                    SurfaceMap* map) {
  return DecimatedSolve(surface, request, control, map).Run();
}

}  // namespace cirque
