#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cirque/cones/cone.h"
#include "cirque/cones/curvature_peaks.h"
#include "cirque/cones/registry.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/pipeline/cone_stages.h"

namespace cirque {
namespace {

constexpr Index kVerticesOfCone = 16;  ///< at least: cones need triangles around them

/// Of the default cones of a closed surface: up to so many start from `greedy`, more from
/// SimpleConeTargets.
constexpr int kMostGreedy = 96;
/// One by one a sweep of them costs a solve a cone; more are moved all at once, for maps as good.
constexpr int kMostMovedOneByOne = 12, kMostSweeps = 30;

/// Of a torus: it gets cones where its area would else range over more than e^4 and over a fifth
/// less with them (docs/maps.md).
constexpr int kConesOfTorus = 8;
constexpr Index kLeastVerticesOfTorus = kVerticesOfCone * kConesOfTorus;
constexpr double kTorusRange = 4, kTorusShare = 0.8;

/// Areas that range over more than e^28 leave fewer than 8 digits to the smallest triangles of a
/// chart in doubles (kAccuracy).
constexpr double kChartRange = 28;
constexpr int kMostConesOfChart = 512;

/// Those of a heuristic by name.
StatusOr<std::vector<Cone>> ConesBy(const std::string& name, const OptionMap& options,
                                    const ConeProblem& problem) {
  const auto heuristic = MakeConeHeuristic(name, options);
  return heuristic.ok() ? (*heuristic)->Choose(problem) : heuristic.status();
}

StatusOr<std::vector<Cone>> GreedyCones(const ConeProblem& problem, int count) {
  return ConesBy("greedy", {{"cones", std::to_string(count)}}, problem);
}

/// `count` cones moved to where the predicted angle distortion is least.
StatusOr<std::vector<Cone>> MovedCones(const ConeProblem& problem, int count) {
  OptionMap options = {{"measure", "angle"},
                       {"max_sweeps", std::to_string(kMostSweeps)},
                       {"one_by_one", std::to_string(kMostMovedOneByOne)}};
  if (count > kMostGreedy) {
    options["start"] = "curvature_peaks";
  } else {
    options["cones"] = std::to_string(count);
  }
  return ConesBy("moving", options, problem);
}

/// By what power of e the area ratios range, as the linear model predicts.
double PredictedAreaRange(const ConeProblem& problem, const std::vector<Cone>& cones) {
  const Eigen::VectorXd u = PredictedLogScale(problem, cones);
  return 2 * (u.maxCoeff() - u.minCoeff());
}

/// The least of count, 2 count, 4 count, ... with which areas range over no more than one chart can
/// hold, as far as the surface has vertices for so many.
int EnoughCones(const ConeProblem& problem, int count) {
  const Index vertices = problem.triangulation().num_vertices;
  const Index most = std::min<Index>(kMostConesOfChart, vertices / kVerticesOfCone);
  for (; 2 * count <= most; count *= 2) {
    const StatusOr<std::vector<Cone>> cones = GreedyCones(problem, count);
    if (!cones.ok() || PredictedAreaRange(problem, *cones) <= kChartRange) break;
  }
  return count;
}

/// None, or kConesOfTorus where they lower the range of areas by much.
StatusOr<std::vector<Cone>> ConesOfTorus(const ConeProblem& problem) {
  const Index vertices = problem.source().surface->triangulation.num_vertices;
  if (vertices < kLeastVerticesOfTorus) return std::vector<Cone>();
  const double range = PredictedAreaRange(problem, {});
  if (!(range > kTorusRange)) return std::vector<Cone>();
  const StatusOr<std::vector<Cone>> cones = MovedCones(problem, kConesOfTorus);
  const bool gains = cones.ok() && PredictedAreaRange(problem, *cones) <= kTorusShare * range;
  return gains ? cones : std::vector<Cone>();
}

/// Those of a closed surface.
StatusOr<std::vector<Cone>> DefaultCones(const ConeProblem& problem) {
  if (problem.TotalCurvature() == 0) return ConesOfTorus(problem);
  const IntrinsicSurface& source = *problem.source().surface;
  const StatusOr<ConeTargets> simple = SimpleConeTargets(source);
  // As on few vertices: as many as Gauss-Bonnet needs.
  if (!simple.ok()) return ConesBy("greedy", {}, problem);
  const std::vector<Cone> cones = ConesOf(source.triangulation, *simple);
  auto count = static_cast<int>(cones.size());
  if (PredictedAreaRange(problem, {}) > kChartRange) {
    count = EnoughCones(problem, count);
  }
  const auto moved = MovedCones(problem, count);
  return moved.ok() ? moved : cones;
}

/// Of a surface with a boundary whose handles ask for more than the boundary can turn: the share of
/// pi a corner that its angle sums can reach (ConeProblem::LeastCurvature), and cones a handle.
constexpr double kReach = 0.6;
constexpr int kConesOfHandle = 4;

/// How many cones a surface with a boundary needs: none, unless the turning that is left to its
/// boundary, 2 pi chi by Gauss-Bonnet, is less than its corners can take.
int NeededBesideBoundary(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  double least_turning = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (surface.boundary[v]) least_turning += kPi * (1 - kReach * surface.corners[v]);
  }
  const Index chi = EulerCharacteristic(t);
  if (least_turning <= 2 * kPi * chi) return 0;
  const auto loops = static_cast<Index>(BoundaryLoops(t).size());
  return kConesOfHandle * std::max<Index>(0, (2 - loops - chi) / 2);
}

/// Those of any surface.
StatusOr<std::vector<Cone>> DefaultConesOf(const ConeProblem& problem) {
  if (problem.IsClosed()) return DefaultCones(problem);
  const int count = NeededBesideBoundary(*problem.source().surface);
  return count == 0 ? std::vector<Cone>() : GreedyCones(problem, count);
}

StatusOr<std::vector<Cone>> ChooseByHeuristic(const ConeProblem& problem,
                                              const ParameterizeOptions& options) {
  if (options.own_cones) return options.own_cones->Choose(problem);
  if (!options.cones.empty()) {
    const auto heuristic = ParseConeHeuristic(options.cones, options.cone_budget);
    return heuristic.ok() ? (*heuristic)->Choose(problem) : heuristic.status();
  }
  if (options.cone_budget >= 0) {
    return Status::InvalidInput("a cone budget needs a heuristic: name it as `cones`, one of " +
                                Join(ConeHeuristics().Names()));
  }
  return DefaultConesOf(problem);
}

/// The options with a heuristic of twice as many cones, if theirs takes a number.
bool DoubleBudget(std::size_t cones, ParameterizeOptions* options) {
  if (options->own_cones) return false;
  if (options->cones.empty()) options->cones = "greedy";
  options->cone_budget = 2 * std::max(1, static_cast<int>(cones));
  return ParseConeHeuristic(options->cones, options->cone_budget).ok();
}

/// Cones with the angles that are asked for: where too few cones leave no multiples that add up,
/// more of them.
StatusOr<std::vector<Cone>> ChooseWithAngles(const ConeProblem& problem,
                                             ParameterizeOptions options,
                                             const ConeAngleOptions& angles) {
  const StatusOr<std::vector<Cone>> cones = ChooseByHeuristic(problem, options);
  if (!cones.ok()) return cones;
  std::size_t count = cones->size();
  StatusOr<std::vector<Cone>> with_angles = ApplyConeAngles(problem, *cones, angles);
  while (!with_angles.ok() && count < problem.candidates().size()) {
    if (!DoubleBudget(count, &options)) break;
    const StatusOr<std::vector<Cone>> more = ChooseByHeuristic(problem, options);
    if (!more.ok() || more->size() <= count) break;
    count = more->size();
    with_angles = ApplyConeAngles(problem, *more, angles);
  }
  return with_angles;
}

constexpr double kSpareCorner = 0.5, kLeastAngle = kPi / 4;

class Repair {
 public:
  Repair(const IntrinsicSurface& surface, const ConeTargets& targets,
         const InfeasibilityCertificate& proof)
      : t_(surface.triangulation),
        corners_(surface.corners),
        boundary_(surface.boundary),
        pointed_at_(surface.triangulation.num_vertices, false) {
    const Triangulation& t = t_;
    repair_.targets = targets;
    std::vector<bool> carries(t.num_vertices, false);
    for (const Index v : proof.carrying_vertices) carries[v] = true;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      for (const Index v : {t.vertex[h], t.Tail(h), t.Tip(h)}) {
        if (carries[v] && IsCone(t.vertex[h])) pointed_at_[t.vertex[h]] = true;
      }
    }
    if (std::find(pointed_at_.begin(), pointed_at_.end(), true) != pointed_at_.end()) return;
    for (Index v = 0; v < t.num_vertices; ++v) pointed_at_[v] = IsCone(v);
  }

  ConeRepair Run(int round) {
    for (Index v = 0; v < t_.num_vertices; ++v) {
      if (round == 1 && pointed_at_[v]) Move(v);
      if (round > 1 && IsCone(v)) Widen(v, (round - 1) * kPi / (pointed_at_[v] ? 4 : 16));
    }
    return repair_;
  }

 private:
  bool IsCone(Index v) const {
    const ConeTargets& targets = repair_.targets;
    return !boundary_[v] && !(targets.lower[v] == 2 * kPi && targets.upper[v] == 2 * kPi);
  }

  void Move(Index v) {
    Index best = v;
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (t_.Tail(h) != v) continue;
      const Index w = t_.Tip(h);
      if (!boundary_[w] && !IsCone(w) && corners_[w] > corners_[best]) best = w;
    }
    if (best == v) return;
    std::swap(repair_.targets.lower[v], repair_.targets.lower[best]);
    std::swap(repair_.targets.upper[v], repair_.targets.upper[best]);
    ++repair_.moved;
  }

  void Widen(Index v, double width) {
    double& lower = repair_.targets.lower[v];
    double& upper = repair_.targets.upper[v];
    const double greatest = kPi * (corners_[v] - kSpareCorner);
    lower = std::min(lower, std::max(kLeastAngle, lower - width));
    upper = std::max(upper, std::min(greatest, upper + width));
    if (pointed_at_[v]) ++repair_.widened;
  }

  const Triangulation& t_;
  const std::vector<Index>& corners_;
  const std::vector<bool>& boundary_;
  std::vector<bool> pointed_at_;
  ConeRepair repair_;
};

}  // namespace

struct ConeSite::Kept {
  Kept(const IntrinsicSurface& surface, const FileVertices& file)
      : delaunay(MakeIntrinsicDelaunay(surface.triangulation, surface.lengths)),
        problem(MeasureSurface(delaunay.triangulation, delaunay.lengths), {&surface, file}) {}

  const IntrinsicTriangulation delaunay;
  const ConeProblem problem;
};

ConeSite::ConeSite(const IntrinsicSurface& surface, FileVertices file)
    : surface_(surface), file_(std::move(file)) {}

ConeSite::~ConeSite() = default;

std::shared_ptr<const ConeProblem> ConeSite::Problem() const {
  const auto made = kept_ ? kept_ : std::make_shared<const Kept>(surface_, file_);
  if (asked_) kept_ = made;
  asked_ = true;
  return {made, &made->problem};
}

int ConesForOneChart(const ConeSite& site, int count) {
  return EnoughCones(*site.Problem(), count);
}

StatusOr<ConeTargets> DefaultTargets(const ConeSite& site) {
  const Triangulation& t = site.surface().triangulation;
  const bool closed = BoundaryLoops(t).empty();
  if (!closed && NeededBesideBoundary(site.surface()) == 0) return FreeBoundaryTargets(t);
  const StatusOr<std::vector<Cone>> cones = DefaultConesOf(*site.Problem());
  return cones.ok() ? ConeTargetsOf(t, *cones) : cones.status();
}

StatusOr<std::vector<Cone>> ChooseCones(const ConeProblem& problem,
                                        const ParameterizeOptions& options) {
  const StatusOr<ConeAngleOptions> angles = ParseConeAngles(options.cone_angles);
  return angles.ok() ? ChooseWithAngles(problem, options, *angles) : angles.status();
}

StatusOr<ConeTargets> PlaceCones(const ConeSite& site, const ParameterizeOptions& options) {
  const ParameterizeOptions plain;
  if (options.cones == plain.cones && options.cone_budget == plain.cone_budget &&
      options.cone_angles == plain.cone_angles && !options.own_cones) {
    return DefaultTargets(site);
  }
  const StatusOr<std::vector<Cone>> cones = ChooseCones(*site.Problem(), options);
  if (!cones.ok()) return cones.status();
  return ConeTargetsOf(site.surface().triangulation, *cones);
}

ConeRepair RepairCones(const IntrinsicSurface& surface, const ConeTargets& targets,
                       const InfeasibilityCertificate& proof, int round) {
  return Repair(surface, targets, proof).Run(round);
}

}  // namespace cirque
