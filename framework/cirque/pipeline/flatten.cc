#include "cirque/pipeline/flatten.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cirque/angles/infeasibility.h"
#include "cirque/core/solve_summary.h"
#include "cirque/layout/untangle.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/pipeline/solve_flat_metric.h"
#include "cirque/radii/solve_log_radii.h"

namespace cirque {
namespace {

constexpr double kKeptShare = 1.0 / 15;  ///< of the mesh's extent, round what came out flipped

double Area(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  const Eigen::VectorXd& length = surface.lengths.value;
  return ParallelSum(t.num_faces(), [&](Index f) {
    return 0.5 * length[t.edge[3 * f]] * length[t.edge[3 * f + 1]] *
           std::sin(surface.angles.value[3 * f + 2]);
  });
}

/// The faces and all that can be reached from them over that many edges.
std::vector<bool> Neighbourhood(const Triangulation& t, std::vector<Index> faces, int edges) {
  std::vector<bool> inside(t.num_faces(), false);
  for (const Index f : faces) inside[f] = true;
  for (int ring = 0; ring < edges; ++ring) {
    std::vector<Index> reached;
    for (const Index f : faces) {
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (t.twin[h] == kNone || inside[Triangulation::Face(t.twin[h])]) continue;
        inside[Triangulation::Face(t.twin[h])] = true;
        reached.push_back(Triangulation::Face(t.twin[h]));
      }
    }
    faces = std::move(reached);
  }
  return inside;
}

/// One surface on its way to a flat metric.
class Flattening {
 public:
  Flattening(const FlattenJob& job, Certificate* certificate, FlatSurface* result)
      : job_(job),
        input_(job.surface.triangulation),
        targets_(job.targets),
        options_(job.options),
        certificate_(*certificate),
        flips_(Fill(&certificate->triangulation)),
        result_(*result),
        source_area_(Area(job.surface)) {}

  Status Run() {
    if (Status s = CheckTargets(job_.surface, targets_, &result_.infeasibility); !s.ok()) return s;
    if (options_.triangulation == SolvedTriangulation::kInput) return SolveOnInput();
    std::vector<bool> locked(input_.num_edges(), false);
    if (job_.locked) locked = *job_.locked;
    flips_.delaunay_rounds = 0;
    const auto flipped = SolveLockingFlipped(
        std::move(locked), [&](const std::vector<bool>& edges) { return SolveRound(edges); },
        [&](const std::vector<Index>& faces, std::vector<bool>* edges) {
          Lock(faces, rounds_solved_++, edges);
          return true;
        });
    if (flipped.ok() && flipped->empty()) return Status();
    if (!flipped.ok() && !MayDoBetterOnInput(flipped.status())) return flipped.status();
    return SolveOnInput();
  }

 private:
  /// Keeps the edges of faces that came out flipped: those faces then are faces of the pattern.
  /// What is kept strains its surroundings, which may come out flipped next; from the second time
  /// on more and more of them is kept, until the border lies where little is to be flipped.
  void Lock(const std::vector<Index>& flipped, int round, std::vector<bool>* locked) const {
    const double extent = std::sqrt(input_.num_faces());  // of the mesh, in edges
    const int edges = static_cast<int>(round * kKeptShare * extent);
    const std::vector<bool> kept = Neighbourhood(input_, flipped, edges);
    for (Index h = 0; h < input_.num_halfedges(); ++h) {
      if (kept[Triangulation::Face(h)]) (*locked)[input_.edge[h]] = true;
    }
  }

  static bool MayDoBetterOnInput(const Status& status) {
    return status.code() == StatusCode::kInfeasible || status.code() == StatusCode::kNotConverged;
  }

  StatusOr<std::vector<Index>> SolveRound(const std::vector<bool>& locked) {
    ++*flips_.delaunay_rounds;
    const Timer timer;
    result_.intrinsic = MakeIntrinsicDelaunay(input_, job_.surface.lengths, {&targets_, locked});
    AddSeconds(timer, &certificate_.seconds.triangulation);
    if (Status s = Solve(); !s.ok()) return s;
    return result_.on_input.flipped;
  }

  Status SolveOnInput() {
    result_.intrinsic = {input_, job_.surface.lengths, {}, {}};
    return Solve();
  }

  Status Solve() {
    flips_.flips = static_cast<int>(result_.intrinsic.flips.size());
    if (Status s = SolveFlatMetric(job_, rounds_solved_ > 0, &certificate_, &result_); !s.ok()) {
      return s;
    }
    const Timer timer;
    ReadBack();
    AddSeconds(timer, &certificate_.seconds.layout);
    return Status();
  }

  const Triangulation& t() const { return result_.intrinsic.triangulation; }

  void ReadBack() {
    const CornerAngles flat = FlatCornerAngles(t(), result_.angles, result_.log_radii);
    ScaleToSurfaceArea(flat);
    result_.intrinsic_lengths = FlatEdgeLengths(t(), flat, result_.log_radii);
    result_.on_input = ReadOnInput(input_, result_.intrinsic, flat, result_.intrinsic_lengths);
    flips_.flipped_in_chart = static_cast<int>(result_.on_input.flipped.size());
    Untangle();
    AddWrapped(flat);
  }

  /// Triangles may turn twice round a vertex without one of them being flipped: its angles add up to
  /// a full turn more than in the flat metric. Then they count as flipped, so that they are kept
  /// from it.
  void AddWrapped(const CornerAngles& flat) {
    std::vector<Index>& flipped = result_.on_input.flipped;
    if (!flipped.empty()) return;
    Eigen::VectorXd excess = Eigen::VectorXd::Zero(input_.num_vertices);
    for (Index c = 0; c < input_.num_halfedges(); ++c) {
      excess[input_.vertex[c]] += result_.on_input.angles.value[c];
      excess[t().vertex[c]] -= flat.value[c];
    }
    for (Index f = 0; f < input_.num_faces(); ++f) {
      const Index* corner = &input_.vertex[3 * f];
      const bool wrapped =
          std::any_of(corner, corner + 3, [&](Index v) { return std::abs(excess[v]) > kPi; });
      if (wrapped) flipped.push_back(f);
    }
  }

  /// Few faces are flipped, if any, and moving a vertex a little rights most of them.
  void Untangle() {
    flips_.moved_vertices = 0;
    if (result_.on_input.flipped.empty()) return;
    std::vector<bool> movable = job_.surface.boundary;
    for (Index v = 0; v < input_.num_vertices; ++v) {
      movable[v] = !movable[v] && targets_.IsFixed(v) && targets_.lower[v] == 2 * kPi;
    }
    flips_.moved_vertices = UntangleFlippedTriangles(job_.surface, movable, &result_.on_input);
  }

  /// Shifts the gauge so that the image has the surface's area.
  void ScaleToSurfaceArea(const CornerAngles& flat) {
    if (!(source_area_ > 0)) return;  // needles alone, whose lengths are those of flat triangles
    const double image_area = ParallelSum(input_.num_faces(), [&](Index f) {
      const double radius = std::exp(result_.log_radii.value[f]);
      double image = 2 * radius * radius;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) image *= std::sin(flat.value[h]);
      return image;
    });
    result_.log_radii.value.array() += 0.5 * std::log(source_area_ / image_area);
  }

  const FlattenJob& job_;
  const Triangulation& input_;
  const ConeTargets& targets_;
  const ParameterizeOptions& options_;
  Certificate& certificate_;
  TriangulationSummary& flips_;
  FlatSurface& result_;
  const double source_area_;
  int rounds_solved_ = 0;  ///< of the lazily constrained loop
};

}  // namespace

StatusOr<std::vector<Index>> SolveLockingFlipped(std::vector<bool> locked,
                                                 const SolveWithLocked& solve,
                                                 const LockFlipped& lock) {
  StatusOr<std::vector<Index>> flipped = solve(locked);
  for (int round = 1; round < kMostLockingRounds; ++round) {
    if (!flipped.ok() || flipped->empty() || !lock(*flipped, &locked)) break;
    flipped = solve(locked);
  }
  return flipped;
}

Status Flatten(const FlattenJob& job, Certificate* certificate, FlatSurface* result) {
  return Flattening(job, certificate, result).Run();
}

}  // namespace cirque
