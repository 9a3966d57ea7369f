// The map of least symmetric Dirichlet energy beside that of another method: results/slim.md.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/corner_places.h"
#include "cirque/domains/domain.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/pipeline/convex_start.h"

#include "experiments/studies/slim_map.h"
#include "experiments/studies/studies.h"

DEFINE_int32(most_steps, 400, "of SLIM");
DEFINE_double(least_gain, 1e-7, "of SLIM's energy, relatively, by one of five steps on end");

namespace cirque {
namespace {

constexpr double kEqual = 1e-5;  ///< of energies, relatively: both descents end before their limit
constexpr double kRounding = 1e-9;  ///< of those of flat surfaces, which are 0

struct Tally {
  int meshes = 0, lower = 0, equal = 0;
};

StatusOr<std::string> RowOf(const std::string& path, Tally* tally) {
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) return soup.status();
  PreflightReport preflight;
  const StatusOr<Surface> surface = Preflight(*soup, &preflight);
  if (!surface.ok()) return surface.status().In(path);
  const Triangulation& t = surface->triangulation;
  if (EulerCharacteristic(t) != 1 || BoundaryLoops(t).size() != 1) {
    return Status::InvalidInput("a disk is needed").In(path);
  }
  MapRequest request;
  request.options.refine_map = "symmetric_dirichlet";
  const Timer timer;
  const StatusOr<SurfaceMap> map = MapSurface(*surface, request);
  if (!map.ok()) return map.status().In(path);
  const double own_seconds = timer.Seconds();
  const std::optional<CornerUv> start =
      EmbedInDisk(MeasureSurface(t, MeasureEdgeLengths(*surface)));
  if (!start) {
    return Status(StatusCode::kUnrepresentable, "doubles hold no convex embedding").In(path);
  }
  const Timer slim_timer;
  const SlimMap slim =
      MinimizeBySlim(*surface, PlacesOfVertices(t, *start), FLAGS_most_steps, FLAGS_least_gain);
  const double slim_seconds = slim_timer.Seconds();
  const double own = SymmetricDirichletOf(*surface, PlacesOfVertices(t, map->uv));
  const double other = SymmetricDirichletOf(*surface, slim.uv);
  ++tally->meshes;
  const double equal = kEqual * own + kRounding;
  tally->equal += std::abs(own - other) <= equal;
  tally->lower += own < other - equal;
  return fmt::format("| {} | {} | {:.7g} | {:.7g} | {} | {:.1f} | {:.1f} |\n",
                     path.substr(path.find_last_of('/') + 1), t.num_faces(), own, other, slim.steps,
                     own_seconds, slim_seconds);
}

constexpr char kAbout[] =
    R"(Disks mapped with `--refine_map=symmetric_dirichlet` at its defaults and by SLIM (M. Rabinovich et al. 2017:
reweighted local and global steps with a line search that flips no face), written from the paper for this comparison
(experiments/studies/slim_map.cc), from a convex embedding. The energy is the area-weighted mean of
(s^2 + t^2 + 1/s^2 + 1/t^2) / 2 - 2 at the best scale of each image, 0 for an isometry, taken of both images by one function. Both have a
free boundary and no cut. SLIM's program here is no faster than need be: its time says little.

| mesh | triangles | `symmetric_dirichlet` | SLIM | SLIM's steps | s | SLIM's s |
|---|--:|--:|--:|--:|--:|--:|
)";

}  // namespace

Status RunSlim(const StudyCall& call) {
  if (call.arguments.empty()) return Status::InvalidInput("no mesh is given; see --help");
  if (FLAGS_most_steps < 1) return Status::InvalidInput("--most_steps: at least 1");
  if (!(FLAGS_least_gain >= 0)) return Status::InvalidInput("--least_gain: at least 0");
  Tally tally;
  std::string rows;
  for (const std::string& path : call.arguments) {
    const StatusOr<std::string> row = RowOf(path, &tally);
    if (!row.ok()) return row.status();
    rows += *row;
  }
  return Deliver(
      fmt::format("# Least symmetric Dirichlet energy\n\nMade by `{}`.\n\nThe energy is lower than "
                  "SLIM's on {} "
                  "and the same to {:.0e} on {} of {} disks. {}{}",
                  call.command, tally.lower, kEqual, tally.equal, tally.meshes, kAbout, rows));
}

}  // namespace cirque
