#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cirque/cones/rotation_model.h"
#include "cirque/cones/seamless_cones.h"
#include "cirque/cones/seamless_search.h"
#include "cirque/core/enum_words.h"
#include "cirque/pipeline/close_rotations.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/solve_flat_metric.h"
#include "cirque/radii/solve_log_radii.h"

namespace cirque {
namespace {

constexpr int kMostRounds = 4;
constexpr double kClosable = 0.02;  ///< [rad]: the angles close it without stretching anything

/// The options with cones of the right angles, and the number that rotations need where nothing is
/// said.
ParameterizeOptions WithCones(const ConeProblem& problem, ParameterizeOptions options) {
  options.cone_angles = ToWord(options.holonomy);
  if (options.AsksForCones() || !problem.IsClosed()) return options;
  const bool halves = options.holonomy == HolonomyRule::kHalves;
  options.cones = "moving";
  options.cone_budget =
      SeamlessBudget(problem, halves ? ConeAngleRule::kHalves : ConeAngleRule::kThirds);
  return options;
}

/// Rounds of moves and fits on the triangulation of a cone problem.
class Rounds {
 public:
  Rounds(const ConeProblem& problem, const ParameterizeOptions& options,
         const SolveControl& control, std::vector<Cone> cones, HolonomySummary* summary)
      : problem_(problem),
        surface_(MeasureSurface(problem.triangulation(), problem.lengths())),
        options_(options),
        control_(control),
        basis_(problem.triangulation()),
        unit_(*RotationUnit(options.holonomy)),
        model_(problem, basis_.loops),
        search_(problem, model_, std::move(cones), unit_),
        best_(search_.cones()),
        summary_(*summary) {
    options_.holonomy = HolonomyRule::kFree;
  }

  const std::vector<Cone>& Run() {
    summary_.holonomy_miss_start = search_.Miss();
    search_.DescendArea(control_.cancelled);
    Eigen::VectorXd offset = Eigen::VectorXd::Zero(model_.size());
    int round = 0;
    while (round < kMostRounds) {
      search_.Run(offset, control_.cancelled);
      if (round == 0) best_ = search_.cones();
      const std::optional<Eigen::VectorXd> finished = Finish();
      if (!finished) break;
      ++round;
      const double miss = MissOf(*finished, unit_).largest;
      if (miss < least_) {
        least_ = miss;
        best_ = search_.cones();
      }
      if (least_ <= kClosable) break;
      offset = *finished - model_.Predict(search_.cones());
    }
    summary_.holonomy_rounds = round;
    summary_.holonomy_moves = search_.moves();
    return best_;
  }

 private:
  /// The rotations of the flat metric with the search's cones; nothing where there is none.
  std::optional<Eigen::VectorXd> Finish() const {
    const Triangulation& t = problem_.triangulation();
    const StatusOr<ConeTargets> targets = ConeTargetsOf(t, search_.cones());
    if (!targets.ok()) return std::nullopt;
    Certificate unused;
    FlatSurface flat;
    flat.intrinsic = {t, problem_.lengths(), {}, {}};
    const FlattenJob job = {surface_, *targets, options_, control_};
    if (!SolveFlatMetric(job, FitStart::kZero, &unused, &flat).ok()) return std::nullopt;
    return basis_.Rotations(FlatCornerAngles(t, flat.angles, flat.log_radii).value);
  }

  const ConeProblem& problem_;
  const IntrinsicSurface surface_;
  ParameterizeOptions options_;
  const SolveControl& control_;
  const LoopBasis basis_;
  const double unit_;
  const RotationModel model_;
  SeamlessSearch search_;
  std::vector<Cone> best_;
  double least_ = std::numeric_limits<double>::infinity();
  HolonomySummary& summary_;
};

}  // namespace

StatusOr<ConeTargets> PlaceSeamlessCones(const ConeSite& site, const ParameterizeOptions& options,
                                         const SolveControl& control, HolonomySummary* summary) {
  const Triangulation& t = site.surface().triangulation;
  const std::shared_ptr<const ConeProblem> made = site.Problem();
  const ConeProblem& problem = *made;
  const ParameterizeOptions with_cones = WithCones(problem, options);
  StatusOr<std::vector<Cone>> cones = ChooseCones(problem, with_cones);
  if (!cones.ok()) return cones.status();
  const bool moves =
      problem.IsClosed() && !cones->empty() && !with_cones.cones.starts_with("given");
  if (!moves) return ConeTargetsOf(t, *cones);
  return ConeTargetsOf(t, Rounds(problem, with_cones, control, *std::move(cones), summary).Run());
}

}  // namespace cirque
