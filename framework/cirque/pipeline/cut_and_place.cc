#include "cirque/pipeline/cut_and_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/text.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/cuts/part_into_charts.h"
#include "cirque/layout/linear_layout.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/convex_start.h"
#include "cirque/pipeline/cut_costs.h"
#include "cirque/pipeline/finish_layout.h"
#include "cirque/pipeline/prescribe_boundary.h"
#include "cirque/pipeline/several_origins.h"

namespace cirque {
namespace {

using Job = ParameterizeJob;

StatusOr<PlanarLayout> LayOutBy(LayoutMethod method, const Triangulation& t, const InputChart& flat,
                                const Cut& cut) {
  if (method == LayoutMethod::kDirections) return LayOutPatches(t, flat.angles, flat.lengths, cut);
  return LayOutByLeastSquares(t, flat.angles, flat.lengths, cut);
}

bool IsFinite(const CornerUv& uv) {
  return std::all_of(uv.value.begin(), uv.value.end(),
                     [](const Eigen::Vector2d& x) { return x.allFinite(); });
}

/// A layout of the flat surface that misses triangles which are not flipped in it.
struct Collapsed {
  const Triangulation& t;
  const InputChart& flat;
  const CornerUv& uv;
  const std::vector<Index>& flipped;
};

/// The least of the face's three heights.
double Width(const Collapsed& layout, Index f) {
  double least = std::numeric_limits<double>::infinity();
  for (Index h = 3 * f; h < 3 * f + 3; ++h) {
    const double side = layout.flat.lengths.value[layout.t.edge[Triangulation::Prev(h)]];
    least = std::min(least, side * std::sin(layout.flat.angles.value[Triangulation::Next(h)]));
  }
  return least;
}

/// Of the doubles next to the face's first corner, the farther apart of both coordinates.
double SpacingAt(const Collapsed& layout, Index f) {
  const double farther = layout.uv.value[3 * f].lpNorm<Eigen::Infinity>();
  return std::nextafter(farther, std::numeric_limits<double>::infinity()) - farther;
}

/// The face that is the narrowest as measured by doubles where it lies.
std::string NarrowestForDoubles(const Collapsed& layout) {
  Index narrowest = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (const Index f : layout.flipped) {
    const double width = Width(layout, f) / SpacingAt(layout, f);
    if (width < least) least = width, narrowest = f;
  }
  if (narrowest == kNone) return "";
  return fmt::format(": face {} (0-based), {:.1e} wide, lies where doubles are {:.1e} apart",
                     narrowest, Width(layout, narrowest), SpacingAt(layout, narrowest));
}

double Range(const Eigen::VectorXd& x) { return x.size() > 0 ? x.maxCoeff() - x.minCoeff() : 0; }

Status Unrepresentable(const Collapsed& layout) {
  return Status(
      StatusCode::kUnrepresentable,
      fmt::format("the flat metric exists but doubles cannot hold it in one chart: the logarithms "
                  "of its lengths range over {:.1f} and {} would collapse, faces {} (0-based) "
                  "among them{}; add cones there, or ask for the exact map (exact), which may lie "
                  "about several origins",
                  Range(layout.flat.lengths.value.array().log()),
                  Count(layout.flipped.size(), "face"), IdList(layout.flipped, 5),
                  NarrowestForDoubles(layout)));
}

/// Whether a map may begin elsewhere than at the conformal one: it is to leave it, and nothing of the
/// flat metric is asked for.
bool MayBeginConvexly(const Job& job, const ConeTargets& targets, const Cut& cut) {
  const Triangulation& t = job.surface.triangulation;
  const bool is_disk = cut.IsEmpty() && EulerCharacteristic(t) == 1 && BoundaryLoops(t).size() == 1;
  return is_disk && LeavesConformal(job.options.refine_map) && !job.options.exact &&
         ConeVertices(job.surface.boundary, targets).empty() &&
         HasFreeBoundary(job.surface, targets);
}

}  // namespace

StatusOr<Cut> ChooseCut(const ParameterizeJob& job, const InputChart& flat,
                        const std::vector<Index>& cones) {
  const Triangulation& t = job.surface.triangulation;
  const Cut given = job.cut ? *job.cut : Cut{std::vector<bool>(t.num_edges(), false)};
  const Index least = std::max(1, job.options.least_charts);
  // What is open enough costs nothing, and costs of edges may take long; a file of them is read.
  if (job.options.edge_costs.empty() && CheckCut(t, given, cones).ok() &&
      (least == 1 || ConnectedPatches(CutOpen(t, given)).count >= least)) {
    return given;
  }
  StatusOr<Eigen::VectorXd> costs =
      CutCosts({job.surface, flat.lengths, job.position}, job.options, job.file.of_vertex);
  if (!costs.ok()) return costs.status();
  for (Index e = 0; job.inside && e < t.num_edges(); ++e) {
    if ((*job.inside)[e]) (*costs)[e] = std::numeric_limits<double>::infinity();
  }
  const StatusOr<Cut> parted =
      PartIntoCharts(job.surface, *costs, given, least, job.control.cancelled);
  return parted.ok() ? CompleteCut(t, *costs, *parted, cones) : parted.status().In("least_charts");
}

Status CutAndPlace(const Job& job, Parameterization* result) {
  const Triangulation& t = job.surface.triangulation;
  Certificate& certificate = result->certificate;
  const InputChart& flat = result->flat.on_input;
  const std::vector<Index> cones = ConeVertices(job.surface.boundary, result->targets);
  StatusOr<Cut> cut = ChooseCut(job, flat, cones);
  if (!cut.ok()) return cut.status();
  StatusOr<PlanarLayout> laid_out = LayOutBy(job.options.layout, t, flat, *cut);
  if (!laid_out.ok()) return laid_out.status();
  PlanarLayout& layout = *laid_out;
  LayoutSummary& summary = Fill(&certificate.layout);
  ScalePieces(job.surface, &layout);
  std::vector<Index> flipped = FlippedFaces(t, layout.uv);
  const bool several_origins = job.alone && !(flipped.empty() && job.alone->empty());
  if (several_origins) {
    const FlatTriangles of = {t, flat, cones};
    if (Status s = LayOutAboutSeveralOrigins(of, *job.alone, &*cut, &layout); !s.ok()) return s;
    flipped.clear();
    summary.origins = static_cast<int>(layout.patches.count);
  }
  if (!IsFinite(layout.uv)) return Unrepresentable({t, flat, layout.uv, flipped});
  std::optional<CornerUv> convex;
  if (!flipped.empty() && MayBeginConvexly(job, result->targets, *cut)) {
    convex = EmbedInDisk(job.surface);
    if (convex) layout.uv = *convex, layout.closure = 0, flipped.clear();
  }
  // The exact map is the result then; that of its own triangles has none beside it.
  const bool may_be_flipped = result->flat.exact.has_value();
  // That of conformal equivalence is not refined (exact_layout.cc); neither is the one beside it.
  const bool as_solved = may_be_flipped && result->flat.exact->equivalent;
  if (!several_origins && (flipped.empty() || may_be_flipped)) {
    LaidOutSurface of = {job.surface, flat, *cut, cones, job.control.cancelled};
    if (flipped.empty() && (convex || flat.flipped.empty()) && !as_solved) {
      job.control.BeginStage("refinement");
      of.injective = job.options.injective && layout.patches.count == 1 &&
                     !OverlapsItself(CutOpen(t, *cut), layout.uv);
      Status refined = RefineLayout(of, result->targets, job.options.refine_map, &layout,
                                    &certificate.map_refinement);
      if (!refined.ok()) return refined;
      if (convex) Fill(&certificate.map_refinement).map_refinement_convex_start = 1;
    }
    // What keeps angles alone leaves the scale of a piece to chance.
    if (!LeavesConformal(job.options.refine_map)) ScalePieces(job.surface, &layout);
    summary.rotation_order = ArrangePatches(of, result->targets, &layout);
    flipped = FlippedFaces(t, layout.uv);
  }
  certificate.seams = SummaryOf(MeasureSeams(t, *cut, cones, flat.angles, layout.uv));
  summary.layout_closure = layout.closure;
  summary.flipped_triangles = static_cast<int>(std::max(flipped.size(), flat.flipped.size()));
  summary.cones = static_cast<int>(cones.size());
  summary.patches = static_cast<int>(layout.patches.count);
  summary.cut_length = RelativeCutLength(job.surface, *cut);
  if (!flipped.empty() && !may_be_flipped) return Unrepresentable({t, flat, layout.uv, flipped});
  result->cut = *std::move(cut);
  result->uv = std::move(layout.uv);
  return Status();
}

void DescribeCut(const Job& job, Parameterization* result) {
  const Triangulation& t = job.surface.triangulation;
  const std::vector<Index> cones = ConeVertices(job.surface.boundary, result->targets);
  Certificate& certificate = result->certificate;
  certificate.seams =
      SummaryOf(MeasureSeams(t, result->cut, cones, result->flat.on_input.angles, result->uv));
  LayoutSummary& summary = Fill(&certificate.layout);
  summary.patches = static_cast<int>(ConnectedPatches(CutOpen(t, result->cut)).count);
  summary.rotation_order = 0;
  summary.cut_length = RelativeCutLength(job.surface, result->cut);
}

}  // namespace cirque
