#include "cirque/cones/moving_cones.h"

#include <algorithm>
#include <utility>

#include "cirque/cones/cone_moves.h"

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
  OptionMap rest = map;
  for (const char* own : {"start", "max_sweeps", "measure", "relocations"}) rest.erase(own);
  auto start = make_start(options.start, rest);
  if (!start.ok()) return start.status().In("moving");
  return std::shared_ptr<const ConeHeuristic>(
      std::make_shared<MovingCones>(*std::move(start), options));
}

StatusOr<std::vector<Cone>> MovingCones::Choose(const ConeProblem& problem) const {
  StatusOr<std::vector<Cone>> cones = start_->Choose(problem);
  if (!cones.ok()) return cones;
  const auto is_fixed = [&](const Cone& c) {
    return c.lower == c.upper && problem.IsCandidate(c.vertex);
  };
  if (cones->empty() || !std::all_of(cones->begin(), cones->end(), is_fixed)) return cones;
  ConeMoves moves(problem, *cones, options_.measure);
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
