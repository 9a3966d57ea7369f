#include "cirque/cones/moving_cones.h"

#include <algorithm>
#include <utility>

#include "cirque/cones/cone_fit.h"
#include "cirque/cones/registry.h"
#include "cirque/mesh/counting_sort.h"

namespace cirque {
namespace {

constexpr int kFirstStride = 8;      ///< edges
constexpr double kLeastGain = 1e-6;  ///< relative, of a move worth making

/// Cones on their way downhill.
class Moves {
 public:
  Moves(const ConeProblem& problem, const std::vector<Cone>& start)
      : problem_(problem),
        corners_at_(
            SortIntoBuckets(problem.triangulation().vertex, problem.triangulation().num_vertices)),
        fit_(problem),
        taken_(problem.triangulation().num_vertices, false),
        stride_(start.size(), kFirstStride) {
    for (const Cone& cone : start) {
      fit_.Add(cone.vertex);
      taken_[cone.vertex] = true;
    }
  }

  bool FitStart() { return fit_.FitLeastSquares(); }

  /// Every cone once; true while some cone may still move.
  bool Sweep() {
    const Eigen::VectorXd slope = fit_.Descent();
    bool moving = false;
    for (int i = 0; i < fit_.size(); ++i) {
      if (stride_[i] == 0) continue;
      const bool moved = TryMove(i, slope);
      stride_[i] = moved ? std::min(kFirstStride, 2 * stride_[i]) : stride_[i] / 2;
      moving = moving || stride_[i] > 0;
    }
    return moving;
  }

  std::vector<Cone> Cones() const { return fit_.Cones(); }

 private:
  bool TryMove(int i, const Eigen::VectorXd& slope) {
    const Index from = fit_.vertices()[i];
    const Index to = Downhill(from, fit_.curvature()[i] * slope, stride_[i]);
    if (to == from) return false;
    const double before = fit_.Distortion();
    fit_.Move(i, to);
    if (!fit_.FitLeastSquares() || fit_.Distortion() > (1 - kLeastGain) * before) {
      fit_.UndoMove();
      return false;
    }
    taken_[from] = false;
    taken_[to] = true;
    return true;
  }

  /// At most `steps` edges down the field, past no other cone.
  Index Downhill(Index v, const Eigen::VectorXd& field, int steps) const {
    const Triangulation& t = problem_.triangulation();
    for (; steps > 0; --steps) {
      Index best = v;
      for (Index i = corners_at_.first[v]; i < corners_at_.first[v + 1]; ++i) {
        const Index h = corners_at_.item[i];
        for (const Index w : {t.Tail(h), t.Tip(h)}) {
          if (!taken_[w] && problem_.IsCandidate(w) && field[w] < field[best]) best = w;
        }
      }
      if (best == v) break;
      v = best;
    }
    return v;
  }

  const ConeProblem& problem_;
  const Buckets corners_at_;
  ConeFit fit_;
  std::vector<bool> taken_;
  std::vector<int> stride_;
};

}  // namespace

const OptionTable<MovingOptions>& MovingOptionTable() {
  static const OptionTable<MovingOptions> kTable("moving", [] {
    auto fields = BudgetFields<MovingOptions>();
    fields.push_back({"start", &MovingOptions::start, 0, 0, {}, "the heuristic that comes first"});
    fields.push_back({"max_sweeps", &MovingOptions::max_sweeps, 0, 1e6, {}, "over all cones"});
    return fields;
  }());
  return kTable;
}

StatusOr<std::shared_ptr<const ConeHeuristic>> MovingCones::Make(const OptionMap& map) {
  MovingOptions options;
  if (Status s = MovingOptionTable().Set(map, &options); !s.ok()) return s;
  if (options.start == "moving") {
    return Status::InvalidInput("moving: start = 'moving' would never begin; name another");
  }
  // The budget is the start's; what it does not take, it refuses.
  OptionMap rest = map;
  rest.erase("start");
  rest.erase("max_sweeps");
  auto start = MakeConeHeuristic(options.start, rest);
  if (!start.ok()) return start.status().In("moving");
  return std::shared_ptr<const ConeHeuristic>(
      std::make_shared<MovingCones>(*std::move(start), options.max_sweeps));
}

StatusOr<std::vector<Cone>> MovingCones::Place(const ConeProblem& problem) const {
  StatusOr<std::vector<Cone>> cones = start_->Place(problem);
  if (!cones.ok()) return cones;
  const auto is_fixed = [&](const Cone& c) {
    return c.lower == c.upper && problem.IsCandidate(c.vertex);
  };
  if (cones->empty() || !std::all_of(cones->begin(), cones->end(), is_fixed)) return cones;
  Moves moves(problem, *cones);
  if (!moves.FitStart()) return cones;
  for (int sweep = 0; sweep < max_sweeps_ && moves.Sweep(); ++sweep) {
  }
  return moves.Cones();
}

}  // namespace cirque
