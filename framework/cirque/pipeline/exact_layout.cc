#include "cirque/pipeline/exact_layout.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/equivalence/half_of_double.h"
#include "cirque/intrinsic/overlay.h"
#include "cirque/intrinsic/straight_lines.h"
#include "cirque/layout/exact_map.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Job = ParameterizeJob;

/// Flags of the job's edges as those of the triangulation that was solved on.
Cut CutOfSolved(const Job& job, const IntrinsicTriangulation& solved) {
  Cut cut{std::vector<bool>(solved.triangulation.num_edges(), false)};
  if (!job.cut) return cut;
  for (std::size_t e = 0; e < job.cut->edge.size(); ++e) {
    if (!job.cut->edge[e]) continue;
    const Index there =
        solved.edge_of_input.empty() ? static_cast<Index>(e) : solved.edge_of_input[e];
    if (there != kNone) cut.edge[there] = true;
  }
  return cut;
}

bool IsCirclePattern(const SolvedMetric& solved) { return !solved.equivalent; }

/// Whether the layout is to be moved, as one piece.
bool PlacesExact(const Job& job) { return job.place_exact && *job.place_exact; }

/// The layout of the triangulation that was solved on, these faces by themselves. A refinement would
/// compare its triangles with the surface's, which Ptolemy flips leave none of.
Status LayOutSolved(const Job& job, const SolvedMetric& solved, const IntrinsicSurface& surface,
                    const Parameterization& whole, const std::vector<Index>& alone,
                    Parameterization* layout) {
  ParameterizeOptions options = job.options;
  options.edge_costs.clear();  // of edges of the input
  if (!IsCirclePattern(solved)) options.refine_map = "none";
  const Cut given = CutOfSolved(job, solved.intrinsic);
  layout->targets = TransferTargets(job.surface, whole.targets, surface);
  layout->flat.log_radii = whole.flat.log_radii;
  layout->flat.on_input = {solved.angles, solved.lengths, {}};
  Job of_solved = {surface, job.file, &given, options, job.control, nullptr, job.position};
  if (!PlacesExact(job)) of_solved.alone = &alone;
  return CutAndPlace(of_solved, layout).In("the exact map");
}

void Summarize(const SolvedMap& of, const Overlay& overlay, const ExactMapRepair& repair,
               ExactMapSummary* summary) {
  const Index wholes = of.part_of ? of.num_wholes : of.input.num_faces();
  std::vector<int> faces_in(wholes, 0);
  for (const Index f : overlay.input_face) {
    const Index whole = of.part_of ? (*of.part_of)[f] : f;
    summary->exact_faces_worst = std::max(summary->exact_faces_worst, ++faces_in[whole]);
  }
  summary->exact_faces_ratio = static_cast<double>(overlay.num_faces()) / wholes;
  summary->exact_crossings = static_cast<int>(overlay.crossing.size());
  summary->exact_edges_spread = repair.edges_spread;
  summary->exact_largest_shift = repair.largest_shift;
}

void SummarizeLayout(const Parameterization& layout, ExactMapSummary* summary) {
  const Certificate& certificate = layout.certificate;
  summary->exact_layout_closure = certificate.layout->layout_closure;
  summary->exact_seam_length_mismatch = certificate.seams->seam_length_mismatch;
  summary->exact_origins = certificate.layout->origins;
}

StatusOr<Overlay> OverlayOf(const Job& job, const SolvedMetric& solved,
                            const IntrinsicSurface& surface) {
  const std::int64_t limit = job.options.exact_limit;
  if (solved.equivalent) return OverlayOf(*solved.equivalent, limit);
  return MakeOverlay(job.surface.triangulation, solved.intrinsic.flips,
                     StraightLines(surface.triangulation, surface.lengths), limit);
}

/// Of the vertices, then the crossings; the largest 0.
std::vector<double> LogWeights(const SolvedMetric& solved, const Overlay& overlay) {
  std::vector<double> weights;
  if (IsCirclePattern(solved)) return weights;
  const Eigen::VectorXd& scale = solved.equivalent->whole.log_scale;
  weights.reserve(overlay.num_vertices + overlay.crossing.size());
  for (Index v = 0; v < overlay.num_vertices; ++v) weights.push_back(-scale[v]);
  for (const Crossing& crossing : overlay.crossing) weights.push_back(crossing.log_weight);
  const double largest = *std::max_element(weights.begin(), weights.end());
  for (double& weight : weights) weight -= largest;
  return weights;
}

/// One attempt at the exact map, these faces of the triangulation that was solved on by themselves; on
/// an error notes which others are too small for doubles where they lie.
Status DrawWith(const Job& job, const IntrinsicSurface& surface, std::vector<Index>* alone,
                Parameterization* result) {
  const SolvedMetric& solved = *result->flat.exact;
  Parameterization layout;
  if (Status s = LayOutSolved(job, solved, surface, *result, *alone, &layout); !s.ok()) return s;
  ExactMapSummary& summary = result->certificate.exact_map.emplace();
  SummarizeLayout(layout, &summary);
  SolvedLayout placed = {
      surface, solved.angles,          std::move(layout.cut), std::move(layout.uv),
      summary, IsCirclePattern(solved)};
  if (PlacesExact(job)) {
    if (Status s = (*job.place_exact)(&placed); !s.ok()) return s;
  }
  StatusOr<Overlay> overlay = OverlayOf(job, solved, surface);
  if (!overlay.ok()) return overlay.status().In("exact_limit");
  ExactMap map;
  const SolvedMap laid_out = {
      job.surface.triangulation, surface, placed.cut, placed.uv, placed.grid, placed.part_of,
      placed.num_wholes};
  if (Status s = DrawExactMap(laid_out, *overlay, &summary, &map, alone); !s.ok()) return s;
  map.log_weight = LogWeights(solved, *overlay);
  Summarize(IsCirclePattern(solved)
                ? DistortionOf(surface.triangulation, surface.lengths, placed.uv)
                : DistortionOf(job.surface, map),
            &summary);
  result->exact_map = std::move(map);
  return Status();
}

Status MakeExact(const Job& job, Parameterization* result) {
  if (!result->flat.exact) {
    return Status(StatusCode::kNotConverged,
                  "the exact map: rounding keeps the boundary from coming back to the double that "
                  "the metric was solved on; leave out exact");
  }
  const SolvedMetric& solved = *result->flat.exact;
  const IntrinsicSurface surface =
      MeasureSurface(solved.intrinsic.triangulation, solved.intrinsic.lengths);
  std::vector<Index> alone;
  for (std::size_t before = 0;; before = alone.size()) {
    Status status = DrawWith(job, surface, &alone, result);
    if (status.ok() || PlacesExact(job) || alone.size() == before) return status;
  }
}

/// Of increasing numbers.
std::vector<Index> Union(const std::vector<Index>& a, const std::vector<Index>& b) {
  std::vector<Index> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

}  // namespace

Status LayOutExactly(const Job& job, Parameterization* result) {
  const Timer timer;
  job.control.BeginStage("exact map");
  Status status = MakeExact(job, result);
  AddSeconds(timer, &result->certificate.seconds.exact);
  return status;
}

Status DrawExactMap(const SolvedMap& of, const Overlay& overlay, ExactMapSummary* summary,
                    ExactMap* map, std::vector<Index>* too_small) {
  ExactMapRepair repair;
  const Triangulation& solved = of.solved.triangulation;
  StatusOr<ExactMap> drawn =
      of.on_sphere ? MakeExactSphereMap(of.input, solved, *of.on_sphere, overlay, &repair)
                   : MakeExactMap(of.input, solved, of.cut, of.uv, overlay, &repair, of.grid);
  Summarize(of, overlay, repair, summary);
  if (!drawn.ok()) {
    if (too_small) *too_small = Union(*too_small, repair.too_small);
    return drawn.status();
  }
  *map = *std::move(drawn);
  summary->exact_triangles = map->num_triangles();
  return Status();
}

void Summarize(const DistortionSummary& distortion, ExactMapSummary* summary) {
  summary->exact_quasi_conformal_mean = distortion.quasi_conformal_mean;
  summary->exact_quasi_conformal_max = distortion.quasi_conformal_max;
  summary->exact_log_area_ratio_l2 = distortion.log_area_ratio_l2;
}

DistortionSummary DistortionOf(const IntrinsicSurface& surface, const ExactMap& map) {
  const Index corners = 3 * map.num_triangles();
  std::vector<Index> vertex(corners);
  std::iota(vertex.begin(), vertex.end(), 0);
  const Triangulation t =
      NumberEdges(corners, std::move(vertex), std::vector<Index>(corners, kNone));
  const CornerUv in_plane = FacesInPlane(surface);
  EdgeLengths lengths{Eigen::VectorXd(corners)};
  CornerUv uv;
  for (Index h = 0; h < corners; ++h) {
    const Index face = map.face_of_input[Triangulation::Face(h)];
    const auto place = [&](Index corner) -> Eigen::Vector2d {
      const Eigen::Vector3d at = InFace(surface.triangulation, map.point[map.corner[corner]], face);
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (int k = 0; k < 3; ++k) sum += at[k] * in_plane.value[3 * face + k];
      return sum;
    };
    lengths.value[h] = (place(Triangulation::Next(h)) - place(Triangulation::Prev(h))).norm();
    uv.value.push_back(map.uv[map.corner_uv[h]]);
  }
  return DistortionOf(t, lengths, uv);
}

}  // namespace cirque
