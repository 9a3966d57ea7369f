// Random small surfaces with random cones that Gauss-Bonnet allows: what is left without a map, by
// circle patterns, by the ladder and by conformal equivalence, and without a flat metric at all:
// results/any_cones.md.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/exact_mesh.h"
#include "cirque/equivalence/solve_log_scales.h"
#include "cirque/mesh/preflight.h"
#include "cirque/pipeline/parameterize.h"
#include "cirque/verify/map_check.h"
#include "cirque/verify/refinement_check.h"

#include "experiments/studies/random_requests.h"
#include "experiments/studies/small_surfaces.h"
#include "experiments/studies/studies.h"

DEFINE_int32(surfaces, 1000, "how many surfaces");
DEFINE_string(ways, "", "only the ways with this in their names; empty: all");
DEFINE_int32(from, 1, "number of the first: it alone decides what the surface and its cones are");

namespace cirque {
namespace {

/// A way to be asked for a map.
struct Way {
  const char* name;
  PatternKind pattern;
  bool strict, exact = false;
};

constexpr std::size_t kListed = 12;  ///< of the surfaces that are left
constexpr char kMetrics[] = "equivalence, on its own triangulation";

constexpr Way kWays[] = {{"circle pattern", PatternKind::kCircle, true},
                         {"circle pattern, ladder", PatternKind::kCircle, false},
                         {"equivalence", PatternKind::kEquivalence, true},
                         {"circle pattern, exact", PatternKind::kCircle, true, true},
                         {"circle pattern, ladder, exact", PatternKind::kCircle, false, true},
                         {"equivalence, exact", PatternKind::kEquivalence, true, true}};

/// What became of the surfaces that one way was asked for.
struct Tally {
  int surfaces = 0, maps = 0, refused = 0;  ///< refused: maps that the verifier does not accept
  int most_iterations = 0, most_flips = 0;
  double seconds = 0;
  std::map<std::string, int> failures;  ///< by outcome
  std::vector<int> numbers;             ///< of the surfaces without an accepted map
};

/// Of an exact map, also as a refinement of the surface.
bool IsAccepted(const PolygonSoup& soup, const Surface& surface, const SurfaceMap& map) {
  if (map.exact_map) {
    const ExactMesh exact = RefineByExactMap(soup, surface, *map.exact_map);
    const auto refinement = verify::CheckRefinement(soup, exact.mesh, exact.polygon);
    if (!refinement.ok() || !refinement->valid()) return false;
    PolygonSoup bare = exact.mesh;
    bare.texture.clear();
    bare.corner_texture.clear();
    const auto report = verify::VerifyMap(bare, exact.mesh, {});
    return report.ok() && report->valid();
  }
  const auto report = verify::VerifyMap(soup, AttachUv(soup, surface, map.uv), {});
  return report.ok() && report->valid();
}

void Try(const Way& way, int number, const PolygonSoup& soup, const Surface& surface,
         const ConeTargets& targets, Tally* tally) {
  MapRequest request;
  request.targets = targets;
  request.options.pattern = way.pattern;
  request.options.strict = way.strict;
  request.options.exact = way.exact;
  Certificate failed;
  const Timer timer;
  const StatusOr<SurfaceMap> map = MapSurface(surface, request, {}, &failed);
  tally->seconds += timer.Seconds();
  ++tally->surfaces;
  const Certificate& certificate = map.ok() ? map->certificate : failed;
  if (certificate.equivalence) {
    tally->most_iterations =
        std::max(tally->most_iterations, certificate.equivalence->scales_iterations);
  }
  if (certificate.triangulation) {
    tally->most_flips = std::max(tally->most_flips, certificate.triangulation->flips);
  }
  const bool accepted = map.ok() && IsAccepted(soup, surface, *map);
  if (accepted) {
    ++tally->maps;
    return;
  }
  tally->numbers.push_back(number);
  if (map.ok()) ++tally->refused;
  if (!map.ok()) ++tally->failures[ToString(map.status().code())];
}

/// The flat metric itself: found, and laid out on the triangulation where it was solved, which may be
/// that of the surface's double.
Status SolveAndLayOut(const Surface& surface, const ConeTargets& targets, LogScalesResult* result) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const auto newton = MakeSolverStrategy("newton");
  Status status;
  for (const KeptEdges kept : {KeptEdges::kBoundary, KeptEdges::kNoEdge}) {
    status = SolveLogScales(surface.triangulation, lengths, targets, kept, **newton, {}, result);
    if (status.code() != StatusCode::kNotConverged) break;
  }
  if (!status.ok()) return status;
  const double largest = result->log_lengths.maxCoeff();
  const EdgeLengths flat{(result->log_lengths.array() - largest).exp()};
  Parameterization map;
  return LayOutFlatMetric(result->intrinsic.triangulation, flat, nullptr, &map);
}

void TryMetric(int number, const Surface& surface, const ConeTargets& targets, Tally* tally) {
  LogScalesResult result;
  const Timer timer;
  const Status status = SolveAndLayOut(surface, targets, &result);
  tally->seconds += timer.Seconds();
  ++tally->surfaces;
  tally->most_iterations = std::max(tally->most_iterations, result.solve.num_iterations());
  tally->most_flips = std::max(tally->most_flips, static_cast<int>(result.intrinsic.flips.size()));
  if (status.ok()) {
    ++tally->maps;
    return;
  }
  tally->numbers.push_back(number);
  ++tally->failures[ToString(status.code())];
}

std::string Row(const std::string& name, const Tally& tally) {
  std::string failures, numbers;
  for (const auto& [outcome, count] : tally.failures) {
    failures += fmt::format("{}{} {}", failures.empty() ? "" : ", ", count, outcome);
  }
  if (tally.refused > 0)
    failures += fmt::format("{}{} not accepted", failures.empty() ? "" : ", ", tally.refused);
  for (std::size_t i = 0; i < std::min(tally.numbers.size(), kListed); ++i) {
    numbers += fmt::format("{}{}", i == 0 ? "" : ", ", tally.numbers[i]);
  }
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {:.1f} | {} |\n", name, tally.surfaces,
                     tally.maps, tally.surfaces - tally.maps, failures.empty() ? "-" : failures,
                     tally.most_iterations, tally.most_flips,
                     1e3 * tally.seconds / std::max(1, tally.surfaces),
                     numbers.empty() ? "-" : numbers);
}

constexpr char kAbout[] =
    R"(surfaces made to be hard, each with up to eight cones of random angles that Gauss-Bonnet allows,
the boundary free or with random angles too. Maps count that the judge of `verify_map` accepts; *left* are the others, by
their outcome. Maps that are linear on the input's triangles do not exist for many cones whatever the metric (a vertex of three
corners has less than 3 pi): *exact* are those that are linear on a refinement of it (`--exact`), which the judge holds against the
surface, too. The last line is the flat metric itself, laid out on the triangulation that it was solved on.
Iterations are those of the log scales, flips those of the last triangulation.

| asked for | surfaces | maps | left | why | most iterations | most flips | ms each | left are, among others |
|---|--:|--:|--:|---|--:|--:|--:|---|
)";

bool IsAsked(const char* way) { return std::string(way).find(FLAGS_ways) != std::string::npos; }

std::string Page(const StudyCall& call, const std::vector<Tally>& tallies) {
  std::string text = fmt::format("# Any cones\n\nMade by `{}`: {}", call.command, kAbout);
  for (std::size_t i = 0; i < std::size(kWays); ++i) {
    if (IsAsked(kWays[i].name)) text += Row(kWays[i].name, tallies[i]);
  }
  if (IsAsked(kMetrics)) text += Row(kMetrics, tallies.back());
  return text;
}

}  // namespace

Status RunAnyCones(const StudyCall& call) {
  if (Status s = NoArguments(call); !s.ok()) return s;
  if (FLAGS_surfaces < 1) return Status::InvalidInput("--surfaces: at least 1");
  const bool any = IsAsked(kMetrics) || std::any_of(std::begin(kWays), std::end(kWays),
                                                    [](const Way& w) { return IsAsked(w.name); });
  if (!any) return Status::InvalidInput("--ways: no way has this in its name");
  std::vector<Tally> tallies(std::size(kWays) + 1);
  for (int number = FLAGS_from; number < FLAGS_from + FLAGS_surfaces; ++number) {
    Dice dice(static_cast<std::uint64_t>(number));
    const auto& kinds = SmallSurfaceKinds();
    const PolygonSoup soup = kinds[dice.Below(static_cast<int>(kinds.size()))].make(&dice);
    PreflightReport preflight;
    const StatusOr<Surface> surface = Preflight(soup, &preflight);
    if (!surface.ok()) continue;
    const ConeTargets targets = DrawCones(surface->triangulation, &dice);
    for (std::size_t i = 0; i < std::size(kWays); ++i) {
      if (IsAsked(kWays[i].name)) Try(kWays[i], number, soup, *surface, targets, &tallies[i]);
    }
    if (IsAsked(kMetrics)) TryMetric(number, *surface, targets, &tallies.back());
  }
  return Deliver(Page(call, tallies));
}

}  // namespace cirque
