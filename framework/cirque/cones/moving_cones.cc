#include "cirque/cones/moving_cones.h"

#include <algorithm>
#include <utility>

#include "cirque/cones/cone_moves.h"
#include "cirque/cones/cone_sweeps.h"

namespace cirque {

const OptionTable<MovingOptions>& MovingOptionTable() {
  using O = MovingOptions;
  static const OptionTable<O> kTable(
      "moving",
      Joined<O>(BudgetOptions<O>(),
                {{"start", &O::start, "the heuristic that comes first"},
                 Option<O>("max_sweeps", &O::max_sweeps, "over all cones").Between(0, 1e6),
                 {"measure", &O::measure, "the distortion that moves lower"},
                 Option<O>("relocations", &O::relocations,
                           "the most cones that are put elsewhere at once")
                     .Between(0, 1e6),
                 Option<O>("one_by_one", &O::one_by_one,
                           "the most cones that are moved one after another; more move all at once")
                     .Between(0, 1e6)}));
  return kTable;
}

StatusOr<std::shared_ptr<const ConeHeuristic>> MovingCones::Make(const OptionMap& map,
                                                                 const StartMaker& make_start) {
  MovingOptions options;
  if (Status s = MovingOptionTable().Set(map, &options); !s.ok()) return s;
  if (options.start == "moving") {
    return Status::InvalidInput("moving: start = 'moving' would never begin; name another");
  }
  // The budget is the start's; what it does not take, it refuses.
  const OptionTable<MovingOptions> of_start("moving", BudgetOptions<MovingOptions>());
  OptionMap budget = map;
  std::erase_if(budget, [&](const auto& option) { return !of_start.Find(option.first); });
  auto start = make_start(options.start, budget);
  if (!start.ok()) return start.status().In("moving");
  return std::shared_ptr<const ConeHeuristic>(
      std::make_shared<MovingCones>(*std::move(start), options));
}

namespace {

constexpr std::size_t kMany = 96;  ///< cones

/// Many of them for less area distortion first, by which those far from where they belong find the way,
/// then for the measure; or for the measure alone, where that did not lower it.
std::vector<Cone> MovedAllAtOnce(const ConeProblem& problem, const std::vector<Cone>& start,
                                 const MovingOptions& options) {
  ConeSweeps from_start(problem, start, options.measure);
  if (options.measure == ConeMeasureKind::kArea || start.size() <= kMany) {
    from_start.Run(options.max_sweeps);
    return from_start.Cones();
  }
  ConeSweeps by_area(problem, start, ConeMeasureKind::kArea);
  by_area.Run(options.max_sweeps);
  ConeSweeps sweeps(problem, by_area.Cones(), options.measure);
  const bool lower = sweeps.Measure() < from_start.Measure();
  ConeSweeps& better = lower ? sweeps : from_start;
  better.Run(options.max_sweeps);
  return better.Cones();
}

}  // namespace

StatusOr<std::vector<Cone>> MovingCones::Choose(const ConeProblem& problem) const {
  StatusOr<std::vector<Cone>> cones = start_->Choose(problem);
  if (!cones.ok()) return cones;
  const auto is_fixed = [&](const Cone& c) {
    return c.lower == c.upper && problem.IsCandidate(c.vertex);
  };
  if (cones->empty() || !std::all_of(cones->begin(), cones->end(), is_fixed)) return cones;
  if (static_cast<int>(cones->size()) > options_.one_by_one) {
    return MovedAllAtOnce(problem, *cones, options_);
  }
  ConeMoves moves(problem, *cones, options_.measure, options_.max_sweeps);
  if (!moves.FitStart()) return cones;
  const auto sweep_to_rest = [&] {
    for (int sweep = 0; sweep < options_.max_sweeps && moves.Sweep(); ++sweep) {
    }
  };
  sweep_to_rest();
  for (int i = 0; i < options_.relocations && moves.Relocate(); ++i) sweep_to_rest();
  moves.FitEnd();
  return moves.Cones();
}

}  // namespace cirque
